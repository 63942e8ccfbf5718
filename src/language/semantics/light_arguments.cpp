// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/light_arguments.h"

#include <span>
#include <string>
#include <string_view>

#include "language/semantics/lint.h"
#include "language/semantics/type_inference.h"
#include "language/semantics/typed_nodes.h"

namespace candela::sl {
namespace {

std::string wordFor(ast::StmtKind kind) {
    return kind == ast::StmtKind::Illuminance  ? "illuminance"
           : kind == ast::StmtKind::Illuminate ? "illuminate"
                                               : "solar";
}

class LightArgumentChecker {
public:
    LightArgumentChecker(const ast::Stmt &statement, const Surroundings &here,
                         ExpressionChecker &expressions)
        : statement_(statement), word_(wordFor(statement.kind)), here_(here),
          expressions_(expressions) {}

    CheckedLight check();

private:
    using Arguments = std::span<const ast::ExprPtr>;

    ExprPtr category(const ast::Expr &);
    /// Takes the names and values behind the cones off the arguments.
    Arguments messages(Arguments);
    void message(const ast::Expr &name, const ast::Expr &value);
    void cones(Arguments);
    void classicCone(Arguments);
    void extendedCones(Arguments);
    Cone cone(Arguments);

    TypeSet types(const ast::ExprPtr &e) const { return typesOf(*e, here_); }
    ExprPtr as(BaseType type, const ast::ExprPtr &e, const std::string &role) {
        return expressions_.checkAs(*e, type, role);
    }

    const ast::Stmt &statement_;
    std::string word_;
    const Surroundings &here_;
    ExpressionChecker &expressions_;
    LightArguments result_;
    std::vector<ExprPtr> received_;
};

CheckedLight LightArgumentChecker::check() {
    Arguments rest = statement_.arguments;
    bool gathers = statement_.kind == ast::StmtKind::Illuminance;
    if (gathers && !rest.empty() && types(rest[0]).isOnly(BaseType::String)) {
        result_.category = category(*rest[0]);
        rest = rest.subspan(1);
    }
    bool positioned = statement_.kind != ast::StmtKind::Solar;
    if (positioned && rest.empty()) {
        here_.reporter.error(statement_.where, word_ + " needs a position");
        return {std::make_unique<LightArguments>(std::move(result_)), std::move(received_)};
    }
    if (positioned) {
        result_.position = as(BaseType::Point, rest[0], "the position of " + word_);
        rest = rest.subspan(1);
    }
    if (gathers)
        rest = messages(rest);
    if (!rest.empty())
        cones(rest);
    return {std::make_unique<LightArguments>(std::move(result_)), std::move(received_)};
}

ExprPtr LightArgumentChecker::category(const ast::Expr &e) {
    ExprPtr result = expressions_.check(e);
    if (result && result->type.isVarying())
        here_.reporter.error(result->where, "the category of illuminance must be uniform");
    return result;
}

LightArgumentChecker::Arguments LightArgumentChecker::messages(Arguments given) {
    size_t first = 0;
    while (first < given.size() && !types(given[first]).isOnly(BaseType::String))
        ++first;
    for (size_t i = first; i < given.size(); i += 2) {
        if (given[i]->kind != ast::ExprKind::Text || i + 1 == given.size()) {
            here_.reporter.error(given[i]->where,
                                 "behind the cones illuminance takes pairs of a name (a string "
                                 "constant, such as \"light:NAME\") and a value");
            break;
        }
        message(*given[i], *given[i + 1]);
    }
    return given.first(first);
}

void LightArgumentChecker::message(const ast::Expr &name, const ast::Expr &value) {
    constexpr std::string_view from = "light:", to = "send:light:";
    const bool isSet = name.text.starts_with(from);
    const bool isArray = typesOf(value, here_).arrayLength > 0;
    ExprPtr checked = isArray ? expressions_.checkWholeArray(value, isSet)
                      : isSet ? expressions_.checkTarget(value)
                              : expressions_.check(value);
    if (name.text.starts_with(to))
        here_.reporter.warnOnce(name.where, "messages to lights (\"send:light:...\") are not "
                                            "delivered: the light's own values count");
    if (!checked || !isSet)
        return;
    ExprPtr call =
        makeNode(ExprKind::Builtin, {BaseType::Float, Detail::Varying, 0}, name.where,
                 list(makeText(name.text.substr(from.size()), name.where), std::move(checked)));
    call->overload = &builtin(BuiltinId::lightsource).overloads[isArray ? 1 : 0];
    received_.push_back(std::move(call));
}

// The type of the argument behind the position decides: a float announces cones. What may be either
// (a noise, say) is read by the number of arguments.
void LightArgumentChecker::cones(Arguments given) {
    TypeSet first = types(given[0]);
    bool either = first.empty() || (first.has(BaseType::Float) && first.hasGeometric());
    bool extended = either ? given.size() != 2 : first.has(BaseType::Float);
    if (extended)
        extendedCones(given);
    else
        classicCone(given);
}

void LightArgumentChecker::classicCone(Arguments given) {
    if (given.size() != 2) {
        here_.reporter.error(given[0]->where, "the classic form of " + word_ +
                                                  " takes an axis and an angle, not " +
                                                  std::to_string(given.size()) +
                                                  " arguments here; with a number of cones "
                                                  "first it takes 4 arguments a cone");
        return;
    }
    result_.form = ConeForm::Classic;
    result_.axis = as(BaseType::Vector, given[0], "the axis of " + word_);
    result_.angle = as(BaseType::Float, given[1], "the angle of " + word_);
    if (looksLikeDegrees(*given[1]))
        here_.reporter.hint(given[1]->where, "the angle of " + word_ +
                                                 " is half of the cone in radians; this looks like "
                                                 "degrees");
}

void LightArgumentChecker::extendedCones(Arguments given) {
    const ast::Expr &count = *given[0];
    Arguments cones = given.subspan(1);
    result_.form = ConeForm::Extended;
    result_.coneCount = as(BaseType::Float, given[0], "the number of cones");
    if (cones.empty() || cones.size() % 4 != 0) {
        here_.reporter.error(
            count.where, "behind the number of cones " + word_ +
                             " takes exactly 4 arguments a cone (axis, angle in degrees, exponent, "
                             "importance); " +
                             std::to_string(cones.size()) + " are given");
        return;
    }
    bool literal = count.kind == ast::ExprKind::Number;
    if (literal && count.number > double(cones.size() / 4))
        here_.reporter.error(count.where, word_ + " announces more cones than the " +
                                              std::to_string(cones.size() / 4) + " that follow");
    for (; !cones.empty(); cones = cones.subspan(4))
        result_.cones.push_back(cone(cones.first(4)));
}

/// Axis, angle, exponent and importance.
Cone LightArgumentChecker::cone(Arguments given) {
    Cone result;
    result.axis = as(BaseType::Vector, given[0], "the axis of a cone");
    result.angle = as(BaseType::Float, given[1], "the angle of a cone");
    result.exponent = as(BaseType::Float, given[2], "the exponent of a cone");
    TypeSet importance = types(given[3]);
    bool color = importance.has(BaseType::Color) && !importance.has(BaseType::Float);
    result.importance =
        as(color ? BaseType::Color : BaseType::Float, given[3], "the importance of a cone");
    if (looksLikeRadians(*given[1]))
        here_.reporter.hint(given[1]->where, "the angle of a cone is its full opening in degrees; "
                                             "this looks like radians");
    return result;
}

} // namespace

bool lightStatementAllowed(const ast::Stmt &s, const Surroundings &here) {
    std::string word = wordFor(s.kind);
    ShaderKind kind = here.names.shaderKind();
    bool gathers = s.kind == ast::StmtKind::Illuminance;
    if (lightUseOf(kind) != (gathers ? LightUse::Receives : LightUse::Gives)) {
        here.reporter.error(s.where, word + " stands only in " +
                                         (gathers ? "surface and volume" : "light") +
                                         " shaders, not in a " + nameOf(kind) + " shader");
        return false;
    }
    if (here.lightStatement) {
        here.reporter.error(s.where, word + " cannot stand inside another light statement");
        return false;
    }
    return true;
}

CheckedLight checkLightArguments(const ast::Stmt &s, const Surroundings &here,
                                 ExpressionChecker &expressions) {
    return LightArgumentChecker(s, here, expressions).check();
}

} // namespace candela::sl
