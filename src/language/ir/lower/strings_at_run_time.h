// SPDX-License-Identifier: Apache-2.0
// The strings of an instance that its code reads from the parameter block (StringValue), and what
// the text does with them that only constants can do.
#pragma once

#include "language/ir/lower/components.h"
#include "language/ir/lower/lower.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace candela::ir {

class StringsAtRunTime {
public:
    StringsAtRunTime(const sl::TypedShader &, const std::vector<StringValue> &);

    /// The strings of a parameter: constants, or what its new slots hold.
    Components read(Builder &, const StringValue &);

    /// The text has to know this string, which is no constant; false if none that is left to run
    /// time can be the reason that it does not.
    bool need(ValueId);
    /// Whether two strings are compared of which one is left, and the other one of the text: then
    /// they differ. What is needed to compare others, as far as they are no constants, is noted.
    bool differ(Builder &, ValueId, ValueId);

    /// The parameters of which a string is needed.
    const std::set<std::string> &needed() const { return needed_; }

private:
    std::set<std::string> texts_; ///< Which none of them is.
    std::set<std::string> left_;  ///< The parameters that have some.
    std::map<ValueId, std::string> parameterOf_;
    std::set<std::string> needed_;
};

} // namespace candela::ir
