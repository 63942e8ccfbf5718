// SPDX-License-Identifier: Apache-2.0
// The expressions of IfBegin and ElseIf (PRMan's conditional RIB):
//
//     $user:pass == 'shadow' && ($Frame >= 10 || !defined(user:quick))
//
// Names of options and attributes ($category:name, $Frame, $Attribute:..., $Option:..., and
// $(expression) for one that is put together), numbers, strings in either quotes; + - * /,
// == != < <= > >=, && || !, parentheses; defined(name), concat(a, b...).
#pragma once

#include "interface/ri/request_sink.h"

#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

namespace candela {

/// What a name stands for; nothing if it is not set. Such a name equals nothing and does not hold.
using ConditionNames = std::function<std::optional<StateValue>(const std::string &name)>;

/// The expression is none: what() says where and why.
struct ConditionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Whether it holds. Throws ConditionError.
bool conditionHolds(const std::string &expression, const ConditionNames &);

} // namespace candela
