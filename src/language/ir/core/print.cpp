// SPDX-License-Identifier: Apache-2.0
// The function as text, for `--emit ir`, tests and people.
#include "language/ir/core/ir.h"
#include "language/ir/core/op_info.h"
#include "language/runtime/runtime_functions.h"

#include <fmt/format.h>
#include <iterator>

namespace candela::ir {

namespace {

constexpr const char *inputNames[] = {
#define SHADER_INPUT(name, components, time, meaning) #name,
#include "language/runtime/shader_inputs.def"
#undef SHADER_INPUT
};
constexpr int inputComponents[] = {
#define SHADER_INPUT(name, components, time, meaning) components,
#include "language/runtime/shader_inputs.def"
#undef SHADER_INPUT
};

std::string inputText(int plane) {
    for (std::size_t i = 0; i < std::size(inputNames); ++i) {
        if (plane < inputComponents[i])
            return inputComponents[i] > 1 ? fmt::format("{}.{}", inputNames[i], plane)
                                          : std::string(inputNames[i]);
        plane -= inputComponents[i];
    }
    return fmt::format("input {}", plane);
}

class Printer {
public:
    explicit Printer(const Function &function) : function_(function) {}

    std::string run() {
        constexpr const char *lanes[] = {"points", "views", "responses"};
        line("function {} of {}, frames {} + {}", function_.name, lanes[int(function_.lanes)],
             function_.surfaceSlots, function_.viewSlots);
        if (!function_.colors.isRgb())
            line("colors of {} samples", function_.colors.samples);
        for (std::size_t i = 0; i < function_.requests.size(); ++i)
            printRequest(int(i), function_.requests[i]);
        for (std::size_t i = 0; i < function_.emissions.size(); ++i)
            line("emission {} {}{} line {}", i,
                 function_.emissions[i].distant ? "distant" : "local",
                 function_.emissions[i].repeated ? " repeated" : "", function_.emissions[i].line);
        for (std::size_t i = 0; i < function_.arrays.size(); ++i)
            line("array {} {} {} [{}]", i, uniformityName(function_.arrays[i].uniformity),
                 typeName(function_.arrays[i].type), function_.arrays[i].size);
        print(function_.body, 1);
        return text_;
    }

private:
    template <typename... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments &&...arguments) {
        text_ += fmt::format(format, std::forward<Arguments>(arguments)...);
        text_ += '\n';
    }

    static const char *uniformityName(Uniformity uniformity) {
        return uniformity == Uniformity::Varying ? "varying" : "uniform";
    }
    static const char *typeName(Type type) {
        constexpr const char *names[] = {"float", "bool", "integer", "string"};
        return names[int(type)];
    }

    void printRequest(int number, const LightRequest &request) {
        constexpr const char *forms[] = {"everywhere", "classic", "extended"};
        line("request {} {} cones {} category {} line {}", number,
             request.kind == LightRequest::Kind::Trace ? "trace" : forms[int(request.form)],
             request.coneCount,
             request.category < 0 ? std::string("all") : function_.categories[request.category],
             request.line);
    }

    std::string value(ValueId v) const {
        constexpr char letters[] = "fbis";
        const Value &known = function_.values[v];
        return fmt::format("{}{}{}", known.uniformity == Uniformity::Varying ? "%" : "$",
                           letters[int(known.type)], v);
    }
    std::string list(const std::vector<ValueId> &values) const {
        std::string text;
        for (ValueId v : values)
            text += (text.empty() ? "" : ", ") + value(v);
        return text;
    }
    static std::string slot(const std::vector<OutputSlot> &slots, int index) {
        return fmt::format("\"{}\".{}", slots[index].name.text(), slots[index].component);
    }

    std::string service(const ServiceUse &use) const {
        std::string text = fmt::format(" {}", use.info->name);
        for (int constant : use.texts)
            text += constant == ServiceUse::atRunTime
                        ? " (last operand)"
                        : fmt::format(" \"{}\"", function_.strings[std::size_t(constant)]);
        return text;
    }

    std::string immediate(const Instruction &i) const {
        if (i.op == Op::ConstFloat)
            return fmt::format(" {:a} ({})", i.number, i.number);
        if (i.op == Op::ConstBool)
            return i.immediate ? " true" : " false";
        switch (info(i.op).immediate) {
        case Immediate::None: return "";
        case Immediate::String: return fmt::format(" \"{}\"", function_.strings[i.immediate]);
        case Immediate::Input: return " " + inputText(i.immediate);
        case Immediate::Space: return fmt::format(" \"{}\"", function_.spaces[i.immediate]);
        case Immediate::Output: return " " + slot(function_.outputs, i.immediate);
        case Immediate::RuntimeFunction:
            return fmt::format(" {}", runtime::info(runtime::RuntimeFunction(i.immediate)).name);
        case Immediate::Parameter: {
            const ParameterSlot &known = function_.parameters[i.immediate];
            return fmt::format(" {} \"{}\".{}", i.immediate, known.name, known.component);
        }
        case Immediate::Service: return service(serviceOf(function_, i));
        case Immediate::Image: {
            const ImageUse &use = function_.images[std::size_t(i.immediate)];
            return fmt::format(" \"{}\"", function_.maps[std::size_t(use.map)]);
        }
        case Immediate::Number:
        case Immediate::Variable:
        case Immediate::Array:
        case Immediate::Site:
        case Immediate::Request:
        case Immediate::RequestOrFinite:
        case Immediate::Category:
        case Immediate::Emission:
        case Immediate::Captured:
        case Immediate::PixelLoop:
        case Immediate::Frame: return fmt::format(" {}", i.immediate);
        case Immediate::Direction: return i.immediate == int(Direction::U) ? " by u" : " by v";
        }
        return "";
    }

    void print(const Region &region, int depth) {
        for (const Instruction &i : region.body)
            print(i, depth);
    }

    void print(const Instruction &i, int depth) {
        std::string indent(2 * depth, ' ');
        std::string results = i.results.empty() ? "" : list(i.results) + " = ";
        std::string operands = i.operands.empty() ? "" : " " + list(i.operands);
        std::string where = i.line ? fmt::format("  ; line {}", i.line) : "";
        line("{}{}{}{}{}{}", indent, results, info(i.op).name, immediate(i), operands, where);
        for (const Region &region : i.regions) {
            line("{}({}) {{", indent, list(region.arguments));
            print(region, depth + 1);
            line("{}}} yields ({})", indent, list(region.yields));
        }
    }

    const Function &function_;
    std::string text_;
};

} // namespace

std::string print(const Function &function) { return Printer(function).run(); }

} // namespace candela::ir
