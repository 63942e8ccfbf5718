// SPDX-License-Identifier: Apache-2.0
// The typed tree as text.
#include <sstream>

#include "language/semantics/typed_ast.h"

#include "foundation/base/deep_stack.h"

namespace candela::sl {
namespace {

std::string operandList(const Expr &e, size_t first = 0) {
    std::string result;
    for (size_t i = first; i < e.operands.size(); ++i)
        result += (i > first ? ", " : "") + print(*e.operands[i]);
    return "(" + result + ")";
}

std::string numberText(double number) {
    std::ostringstream stream;
    stream << number;
    return stream.str();
}

class Printer {
public:
    std::string text;

    void line(const std::string &s) { text += std::string(size_t(depth_) * 2, ' ') + s + "\n"; }

    void list(const std::vector<StmtPtr> &statements) {
        ++depth_;
        for (const StmtPtr &s : statements)
            statement(*s);
        --depth_;
    }

    void statement(const Stmt &s) {
        std::string value = s.value ? " " + print(*s.value) : "";
        switch (s.kind) {
        case StmtKind::Block: line("block"); break;
        case StmtKind::Declare: line(declaration(s)); break;
        case StmtKind::Evaluate: line(value.substr(1)); break;
        case StmtKind::If: line("if" + value); break;
        case StmtKind::Loop: line("loop" + value); break;
        case StmtKind::Break: line("break"); break;
        case StmtKind::Continue: line("continue"); break;
        case StmtKind::Return: line("return" + value); break;
        case StmtKind::Illuminance: line("illuminance" + lightText(*s.light)); break;
        case StmtKind::Illuminate: line("illuminate" + lightText(*s.light)); break;
        case StmtKind::Solar: line("solar" + lightText(*s.light)); break;
        }
        list(s.body);
        if (!s.otherwise.empty()) {
            line("else");
            list(s.otherwise);
        }
        for (const ExprPtr &step : s.steps)
            line("step " + print(*step));
    }

private:
    static std::string declaration(const Stmt &s) {
        std::string result = nameOf(s.symbol->type) + " " + s.symbol->name;
        for (const ExprPtr &value : s.values)
            result += (&value == &s.values[0] ? " = " : ", ") + print(*value);
        return result;
    }

    static std::string lightText(const LightArguments &light) {
        std::string result;
        for (const ExprPtr *e :
             {&light.category, &light.position, &light.axis, &light.angle, &light.coneCount})
            if (*e)
                result += " " + print(**e);
        for (const Cone &cone : light.cones)
            result += " [" + print(*cone.axis) + " " + print(*cone.angle) + " " +
                      print(*cone.exponent) + " " + print(*cone.importance) + "]";
        return result;
    }

    int depth_ = 0;
};

} // namespace

std::string print(const Expr &e) {
    auto operand = [&](size_t i) { return print(*e.operands[i]); };
    switch (e.kind) {
    case ExprKind::Number: return numberText(e.number);
    case ExprKind::Text: return '"' + e.text + '"';
    case ExprKind::Tuple: return std::string(nameOf(e.type.base)) + operandList(e);
    case ExprKind::Variable: return e.symbol->name;
    case ExprKind::Element:
    case ExprKind::Component: return operand(0) + "[" + operand(1) + "]";
    case ExprKind::Negate: return "-" + operand(0);
    case ExprKind::Not: return "!" + operand(0);
    case ExprKind::Binary: return "(" + operand(0) + " " + nameOf(e.op) + " " + operand(1) + ")";
    case ExprKind::Conditional:
        return "(" + operand(0) + " ? " + operand(1) + " : " + operand(2) + ")";
    case ExprKind::Assign: return operand(0) + " = " + operand(1);
    case ExprKind::TargetValue: return "target";
    case ExprKind::Convert: return std::string(nameOf(e.type.base)) + "<" + operand(0) + ">";
    case ExprKind::FromSpace:
        return std::string(nameOf(e.type.base)) + "<" + operand(0) + " from " + operand(1) + ">";
    case ExprKind::Call: return e.function->name + operandList(e);
    case ExprKind::Builtin:
        return std::string(e.overload->function->name) + ":" + nameOf(e.overload->result) +
               operandList(e);
    }
    return {};
}

static std::string printed(const TypedShader &shader) {
    Printer printer;
    printer.line(std::string(nameOf(shader.kind)) + " " + shader.name);
    for (const Parameter &parameter : shader.parameters) {
        std::string text =
            "parameter " + nameOf(parameter.symbol->type) + " " + parameter.symbol->name;
        for (const ExprPtr &value : parameter.defaults)
            text += (&value == &parameter.defaults[0] ? " = " : ", ") + print(*value);
        printer.line(text);
    }
    printer.list(shader.body);
    for (const auto &function : shader.functions) {
        printer.line("function " + nameOf(function->result) + " " + function->name);
        printer.list(function->body);
    }
    return printer.text;
}

std::string print(const TypedShader &shader) {
    std::string text;
    onDeepStack([&] { text = printed(shader); });
    return text;
}

} // namespace candela::sl
