// SPDX-License-Identifier: Apache-2.0
// illuminance, illuminate and solar, classic and with the paper's cones (ALGORITHMS 0 and 1). The
// type of the argument behind the position decides: a float announces cones.
#include "language/semantics/checker.h"
#include "language/semantics/lint.h"

namespace candela::sl {

static std::string wordFor(ast::StmtKind kind) {
    return kind == ast::StmtKind::Illuminance  ? "illuminance"
           : kind == ast::StmtKind::Illuminate ? "illuminate"
                                               : "solar";
}

bool Checker::lightStatementAllowed(const ast::Stmt &s) {
    std::string word = wordFor(s.kind);
    bool gathers = s.kind == ast::StmtKind::Illuminance;
    bool light = shader_->kind == ShaderKind::Light;
    bool receives = shader_->kind == ShaderKind::Surface || shader_->kind == ShaderKind::Volume;
    if (gathers ? !receives : !light) {
        reporter_.error(s.where, word + " stands only in " +
                                     (gathers ? "surface and volume" : "light") +
                                     " shaders, not in a " + nameOf(shader_->kind) + " shader");
        return false;
    }
    if (context_.lightStatement) {
        reporter_.error(s.where, word + " cannot stand inside another light statement");
        return false;
    }
    return true;
}

void Checker::lightStatement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    if (!lightStatementAllowed(s))
        return;
    StmtKind kind = s.kind == ast::StmtKind::Illuminance  ? StmtKind::Illuminance
                    : s.kind == ast::StmtKind::Illuminate ? StmtKind::Illuminate
                                                          : StmtKind::Solar;
    StmtPtr result = make(kind, s.where);
    result->light = lightArguments(s);
    if (context_.function)
        context_.function->hasLightStatement = true;
    bool outer = context_.varyingControl;
    context_.varyingControl = true;
    context_.lightStatement = result.get();
    context_.loops.push_back(result.get());
    scopedStatement(*s.body[0], result->body);
    context_.loops.pop_back();
    context_.lightStatement = nullptr;
    context_.varyingControl = outer;
    out.push_back(std::move(result));
}

std::unique_ptr<LightArguments> Checker::lightArguments(const ast::Stmt &s) {
    auto result = std::make_unique<LightArguments>();
    std::string word = wordFor(s.kind);
    size_t next = 0;
    bool gathers = s.kind == ast::StmtKind::Illuminance;
    if (gathers && !s.arguments.empty() && typesOf(*s.arguments[0]).isOnly(BaseType::String)) {
        result->category = check(*s.arguments[next++]);
        if (result->category && result->category->type.isVarying())
            reporter_.error(result->category->where, "the category of illuminance must be uniform");
    }
    if (s.kind != ast::StmtKind::Solar) {
        if (next >= s.arguments.size()) {
            reporter_.error(s.where, word + " needs a position");
            return result;
        }
        result->position =
            checkAs(*s.arguments[next++], BaseType::Point, "the position of " + word);
    }
    coneArguments(s, next, *result);
    return result;
}

void Checker::coneArguments(const ast::Stmt &s, size_t first, LightArguments &light) {
    std::string word = wordFor(s.kind);
    size_t given = s.arguments.size() - first;
    if (given == 0)
        return;
    TypeSet types = typesOf(*s.arguments[first]);
    // What may be either (a noise, say) is read by the number of arguments.
    bool either = types.empty() || (types.has(BaseType::Float) && types.hasGeometric());
    bool extended = either ? given != 2 : types.has(BaseType::Float);
    if (extended)
        return extendedCones(s, first, light);
    if (given != 2) {
        reporter_.error(s.arguments[first]->where, "the classic form of " + word +
                                                       " takes an axis and an angle, not " +
                                                       std::to_string(given) +
                                                       " arguments here; with a number of cones "
                                                       "first it takes 4 arguments a cone");
        return;
    }
    light.form = ConeForm::Classic;
    light.axis = checkAs(*s.arguments[first], BaseType::Vector, "the axis of " + word);
    light.angle = checkAs(*s.arguments[first + 1], BaseType::Float, "the angle of " + word);
}

void Checker::extendedCones(const ast::Stmt &s, size_t first, LightArguments &light) {
    std::string word = wordFor(s.kind);
    const ast::Expr &countSyntax = *s.arguments[first];
    size_t given = s.arguments.size() - first - 1;
    light.form = ConeForm::Extended;
    light.coneCount = checkAs(countSyntax, BaseType::Float, "the number of cones");
    if (given == 0 || given % 4 != 0) {
        reporter_.error(countSyntax.where,
                        "behind the number of cones " + word +
                            " takes exactly 4 arguments a cone (axis, angle in degrees, exponent, "
                            "importance); " +
                            std::to_string(given) + " are given");
        return;
    }
    bool literal = countSyntax.kind == ast::ExprKind::Number;
    if (literal && countSyntax.number > double(given / 4))
        reporter_.error(countSyntax.where, word + " announces more cones than the " +
                                               std::to_string(given / 4) + " that follow");
    for (size_t i = first + 1; i + 3 < s.arguments.size(); i += 4) {
        Cone cone;
        const ast::Expr &angle = *s.arguments[i + 1], &importance = *s.arguments[i + 3];
        cone.axis = checkAs(*s.arguments[i], BaseType::Vector, "the axis of a cone");
        cone.angle = checkAs(angle, BaseType::Float, "the angle of a cone");
        cone.exponent = checkAs(*s.arguments[i + 2], BaseType::Float, "the exponent of a cone");
        TypeSet types = typesOf(importance);
        bool color = types.has(BaseType::Color) && !types.has(BaseType::Float);
        cone.importance = checkAs(importance, color ? BaseType::Color : BaseType::Float,
                                  "the importance of a cone");
        if (looksLikeRadians(angle))
            reporter_.warning(angle.where, "the angle of a cone is its full opening in degrees; "
                                           "this looks like radians");
        light.cones.push_back(std::move(cone));
    }
}

} // namespace candela::sl
