// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/overload_choice.h"

#include <algorithm>
#include <vector>

#include "language/semantics/call_cost.h"
#include "language/semantics/type_inference.h"
#include "language/semantics/user_functions.h"

namespace candela::sl {
namespace {

/// Keeps the cheapest of the callees that it is shown; of equals, the first.
class Choice {
public:
    Choice(const ast::Expr &call, std::optional<BaseType> wanted, const Surroundings &here)
        : call_(call), wanted_(wanted), here_(here), arguments_(argumentTypes(call, here)) {}

    const Callee &best() const { return best_; }

    /// Of the user's functions, those whose instance is just being checked or the others.
    void considerOwn(const std::vector<FunctionDefinition *> &definitions, bool inProgress) {
        for (FunctionDefinition *definition : definitions) {
            int cost = callCost(*definition->syntax, call_, arguments_);
            if (cost < impossible && definition->inProgress == inProgress)
                consider({nullptr, definition}, cost, here_.functions.resultOf(*definition));
        }
    }

    void considerBuiltin(const Builtin &function) {
        for (const BuiltinOverload &overload : function.overloads)
            consider({&overload, nullptr}, callCost(overload, call_, arguments_), overload.result);
    }

private:
    void consider(const Callee &candidate, int cost, BaseType result) {
        if (cost >= impossible)
            return;
        int total = cost + contextCost(result, wanted_);
        if (total >= bestCost_)
            return;
        best_ = candidate;
        bestCost_ = total;
    }

    const ast::Expr &call_;
    std::optional<BaseType> wanted_;
    const Surroundings &here_;
    std::vector<TypeSet> arguments_;
    Callee best_;
    int bestCost_ = impossible;
};

std::string signatureOf(const ast::Function &function) {
    std::string list;
    for (const ast::Variable &formal : function.formals)
        list += (list.empty() ? "" : ", ") + std::string(formal.output ? "output " : "") +
                nameOf(formal.type) + " " + formal.name + (formal.isArray ? "[]" : "");
    std::string result = function.result ? nameOf(*function.result) + std::string(" ") : "";
    return result + function.name + "(" + list + ")";
}

} // namespace

Callee chooseCallee(const ast::Expr &call, std::optional<BaseType> wanted,
                    const Surroundings &here) {
    Choice choice(call, wanted, here);
    const auto definitions = here.names.functions(call.text);
    choice.considerOwn(definitions, false);
    const Builtin *function = findBuiltin(call.text);
    if (!choice.best().definition && function)
        choice.considerBuiltin(*function);
    if (!choice.best().definition && !choice.best().overload)
        choice.considerOwn(definitions, true); // A recursion, which is reported.
    return choice.best();
}

std::string signatures(const std::string &name, const Names &names) {
    std::vector<std::string> forms;
    for (FunctionDefinition *definition : names.functions(name))
        forms.push_back(signatureOf(*definition->syntax));
    if (const Builtin *function = findBuiltin(name))
        for (const BuiltinOverload &overload : function->overloads)
            forms.push_back(overload.signature());
    std::string result;
    constexpr size_t shown = 4;
    for (size_t i = 0; i < std::min(forms.size(), shown); ++i)
        result += (i ? "; " : "") + forms[i];
    if (forms.size() > shown)
        result += "; and " + std::to_string(forms.size() - shown) + " more";
    return result;
}

} // namespace candela::sl
