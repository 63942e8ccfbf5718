// SPDX-License-Identifier: Apache-2.0
#include "foundation/units/color.h"
#include "language/ir/core/ir.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/uniformity.h"
#include "language/runtime/runtime_functions.h"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace candela::ir {

namespace {

/// Walks the function with the set of values that are visible; keeps the first fault.
class Verifier {
public:
    Verifier(const Function &function, bool mayHaveSlopes)
        : function_(function), mayHaveSlopes_(mayHaveSlopes), visible_(function.values.size()),
          defined_(function.values.size()) {}

    std::string run() {
        if (!function_.body.arguments.empty() || !function_.body.yields.empty())
            return "the body has arguments or yields";
        check(function_.body);
        if (fault_.empty())
            checkUniformity();
        return fault_;
    }

private:
    bool fail(const Instruction &i, std::string_view what) {
        if (fault_.empty())
            fault_ = fmt::format("{} (line {}): {}", int(i.op) < opCount ? info(i.op).name : "?",
                                 i.line, what);
        return false;
    }
    bool expect(const Instruction &i, bool condition, std::string_view what) {
        return condition || fail(i, what);
    }

    bool canUse(ValueId v) const { return v < visible_.size() && visible_[v]; }
    Type type(ValueId v) const { return function_.values[v].type; }

    bool define(const Instruction &i, const std::vector<ValueId> &values,
                std::vector<ValueId> &scope) {
        for (ValueId v : values) {
            if (v >= visible_.size())
                return fail(i, fmt::format("value {} does not exist", v));
            if (defined_[v])
                return fail(i, fmt::format("value {} is defined twice", v));
            defined_[v] = visible_[v] = true;
            scope.push_back(v);
        }
        return true;
    }

    /// `owner` is the instruction that the region belongs to, for messages.
    void check(const Region &region, const Instruction *owner = nullptr) {
        std::vector<ValueId> scope;
        Instruction none;
        const Instruction &place = owner ? *owner : none;
        define(place, region.arguments, scope);
        for (const Instruction &i : region.body) {
            if (!fault_.empty())
                return;
            check(i, scope);
        }
        for (ValueId v : region.yields)
            expect(place, canUse(v), fmt::format("yields {}, which is not visible", v));
        for (ValueId v : scope)
            visible_[v] = false;
    }

    void check(const Instruction &i, std::vector<ValueId> &scope) {
        if (int(i.op) >= opCount) {
            fail(i, "no such operation");
            return;
        }
        for (ValueId v : i.operands)
            if (!canUse(v)) {
                fail(i, fmt::format("uses {}, which is not visible", v));
                return;
            }
        if (!checkImmediate(i) || !checkRegionCount(i))
            return;
        for (const Region &region : i.regions)
            check(region, &i);
        if (fault_.empty() && define(i, i.results, scope))
            checkTypes(i);
    }

    bool checkRegionCount(const Instruction &i) {
        const int count = info(i.op).regions;
        return expect(i, int(i.regions.size()) == count, fmt::format("has not {} regions", count));
    }

    bool checkImmediate(const Instruction &i) {
        auto below = [&](std::size_t size) {
            return expect(i, i.immediate >= 0 && std::size_t(i.immediate) < size,
                          fmt::format("immediate {} is out of range", i.immediate));
        };
        switch (info(i.op).immediate) {
        case Immediate::None:
        case Immediate::Number:
        case Immediate::Site: return true;
        case Immediate::String: return below(function_.strings.size());
        case Immediate::Input: return below(std::size_t(ShaderInput::Count));
        case Immediate::Parameter: return below(function_.parameters.size());
        case Immediate::Variable: return below(function_.variables.size());
        case Immediate::Captured: return expect(i, i.immediate >= 0, "captures nothing");
        case Immediate::Image: return below(function_.images.size());
        case Immediate::PixelLoop: return below(function_.pixelLoops.size());
        case Immediate::Space: return below(function_.spaces.size());
        case Immediate::Array: return below(function_.arrays.size());
        case Immediate::RuntimeFunction: return below(std::size_t(runtime::RuntimeFunction::Count));
        case Immediate::Service: return below(function_.services.size());
        case Immediate::Request: return below(function_.requests.size());
        case Immediate::RequestOrFinite:
            return i.immediate == finiteRequests || below(function_.requests.size());
        case Immediate::Emission: return below(function_.emissions.size());
        case Immediate::Category: return below(function_.categories.size());
        case Immediate::Output: return below(function_.outputs.size());
        case Immediate::Frame:
            return below(std::size_t(function_.surfaceSlots + function_.viewSlots));
        case Immediate::Direction:
            return expect(i, mayHaveSlopes_, "is not written out") && below(directionCount);
        }
        return false;
    }

    bool checkTypes(const Instruction &i) {
        switch (i.op) {
        case Op::If: return checkIf(i);
        case Op::Loop: return checkLoop(i);
        case Op::LightLoop: return checkLightLoop(i);
        case Op::Call: {
            auto known = runtime::info(runtime::RuntimeFunction(i.immediate));
            return checkAll(i, i.operands, known.inputs) && checkAll(i, i.results, known.outputs);
        }
        case Op::FrameStore:
            return expect(i, i.operands.size() == 1 && i.results.empty(), "wrong arity") &&
                   expect(i, type(i.operands[0]) != Type::String, "saves a string");
        case Op::Query:
        case Op::Command: return checkService(i);
        case Op::ImageLoad:
            return checkAll(i, i.operands, runtime::lookupOperands) &&
                   checkAll(i, i.results, function_.images[std::size_t(i.immediate)].values);
        case Op::ImageStore:
            return checkAll(i, i.operands, 2 + function_.images[std::size_t(i.immediate)].values);
        case Op::PixelLoop: {
            const PixelLoop &loop = function_.pixelLoops[std::size_t(i.immediate)];
            return checkAll(i, i.operands, loop.given()) &&
                   checkAll(i, i.results, int(loop.sums.size()));
        }
        default: return checkLetters(i);
        }
    }

    bool checkService(const Instruction &i) {
        const ServiceUse &use = serviceOf(function_, i);
        const auto purity = i.op == Op::Query ? ServicePurity::Query : ServicePurity::Command;
        const auto known = [&](int text) {
            return text >= 0 && std::size_t(text) < function_.strings.size();
        };
        const int chosen = use.hasTextAtRunTime();
        if (!expect(i, !chosen || (!i.operands.empty() && type(i.operands.back()) == Type::String),
                    "has no string for its first text"))
            return false;
        return expect(i, use.info && use.info->purity == purity, "asks no service of its kind") &&
               expect(i,
                      int(use.texts.size()) == use.info->texts &&
                          std::all_of(use.texts.begin() + chosen, use.texts.end(), known),
                      "wrong constant strings") &&
               checkOperandsOf(i, use.info->operands, chosen) &&
               (use.info->results == "*" ||
                checkLetters(i, use.info->results, i.results, Type::Float, "result")) &&
               checkAll(i, i.results, use.results);
    }

    /// Of a service, but for the last ones, which its row does not know of; '*' behind the letters
    /// stands for further operands of any type.
    bool checkOperandsOf(const Instruction &i, std::string_view letters, int last) {
        std::vector<ValueId> named(i.operands.begin(), i.operands.end() - last);
        if (letters.ends_with('*')) {
            letters.remove_suffix(1);
            named.resize(std::min(named.size(), letters.size()));
        }
        return checkLetters(i, letters, named, Type::Float, "operand");
    }

    bool checkAll(const Instruction &i, const std::vector<ValueId> &values, int count) {
        if (!expect(i, int(values.size()) == count, "wrong arity"))
            return false;
        for (ValueId v : values)
            if (!expect(i, type(v) == Type::Float, "takes and gives floats"))
                return false;
        return true;
    }

    bool checkLetters(const Instruction &i) {
        const OpInfo &table = info(i.op);
        const Type same = isArrayAccess(i.op)  ? function_.arrays[i.immediate].type
                          : i.operands.empty() ? Type::Float
                                               : type(i.operands.back());
        return checkLetters(i, table.operands, i.operands, same, "operand") &&
               checkLetters(i, table.results, i.results, same, "result");
    }

    bool checkLetters(const Instruction &i, std::string_view letters,
                      const std::vector<ValueId> &values, Type same, const char *what) {
        std::vector<Type> types;
        for (char letter : letters)
            types.insert(types.end(), countOf(letter, function_.colors.samples),
                         letter == '.' ? same : typeOf(letter));
        if (!expect(i, values.size() == types.size(), "wrong arity"))
            return false;
        for (std::size_t k = 0; k < values.size(); ++k)
            if (!expect(i, type(values[k]) == types[k],
                        fmt::format("{} {} is of the wrong type", what, k)))
                return false;
        return true;
    }

    bool sameTypes(const Instruction &i, const std::vector<ValueId> &a,
                   const std::vector<ValueId> &b, std::size_t skip, const char *what) {
        if (!expect(i, a.size() == b.size() + skip, fmt::format("{}: wrong number", what)))
            return false;
        for (std::size_t k = 0; k < b.size(); ++k)
            if (!expect(i, type(a[k + skip]) == type(b[k]), fmt::format("{}: wrong type", what)))
                return false;
        return true;
    }

    bool checkIf(const Instruction &i) {
        if (!expect(i, i.operands.size() == 1 && type(i.operands[0]) == Type::Bool,
                    "needs one bool"))
            return false;
        for (const Region &region : i.regions)
            if (!expect(i, region.arguments.empty(), "its regions take no arguments") ||
                !sameTypes(i, region.yields, i.results, 0, "yields"))
                return false;
        return true;
    }

    bool checkLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        return expect(i, !i.operands.empty() && type(i.operands[0]) == Type::Bool,
                      "carries no condition") &&
               sameTypes(i, i.operands, i.results, 0, "results") &&
               sameTypes(i, region.arguments, i.results, 0, "arguments") &&
               sameTypes(i, region.yields, i.results, 0, "yields");
    }

    /// L, Cl and the light's number.
    std::size_t givenByLight() const { return std::size_t(3 + function_.colors.samples + 1); }

    bool checkLightLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        const LightRequest &request = function_.requests[i.immediate];
        int perCone = request.form == ConeForm::Classic ? 4 : 6;
        std::size_t fixed = 3;
        if (request.form != ConeForm::Everywhere)
            fixed += std::size_t(perCone * request.coneCount);
        if (!sameTypes(i, i.operands, i.results, fixed, "operands") ||
            !sameTypes(i, region.arguments, i.results, givenByLight(), "arguments") ||
            !sameTypes(i, region.yields, i.results, 0, "yields"))
            return false;
        std::vector<ValueId> floats(i.operands.begin(), i.operands.begin() + fixed);
        floats.insert(floats.end(), region.arguments.begin(),
                      region.arguments.begin() + std::ptrdiff_t(givenByLight()));
        return checkAll(i, floats, int(floats.size()));
    }

    /// What is said to vary may be uniform, never the other way.
    void checkUniformity() {
        Function inferred = function_;
        inferUniformity(inferred);
        for (std::size_t v = 0; v < function_.values.size(); ++v)
            if (inferred.values[v].uniformity > function_.values[v].uniformity && fault_.empty())
                fault_ = fmt::format("value {} varies but is said to be uniform", v);
        for (std::size_t a = 0; a < function_.arrays.size(); ++a)
            if (inferred.arrays[a].uniformity > function_.arrays[a].uniformity && fault_.empty())
                fault_ = fmt::format("array {} varies but is said to be uniform", a);
    }

    const Function &function_;
    const bool mayHaveSlopes_;
    std::vector<bool> visible_; ///< May be used here.
    std::vector<bool> defined_; ///< Was defined somewhere.
    std::string fault_;
};

} // namespace

std::string verify(const Function &function, bool mayHaveSlopes) {
    return Verifier(function, mayHaveSlopes).run();
}

} // namespace candela::ir
