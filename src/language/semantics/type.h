// SPDX-License-Identifier: Apache-2.0
// The type of a value: what it is, how many, and whether it varies.
#pragma once

#include <string>

#include "language/syntax/base_type.h"

namespace candela::sl {

struct Type {
    BaseType base = BaseType::Void;
    Detail detail = Detail::Uniform;
    int length = 0; ///< 0: a single value; n > 0: an array of n.

    bool isArray() const { return length > 0; }
    bool isVarying() const { return detail == Detail::Varying; }
    friend bool operator==(const Type &, const Type &) = default;
};

/// "varying color[4]", as messages name it.
std::string nameOf(const Type &);
/// "color[4]": the type without its detail.
std::string shapeOf(const Type &);

/// The detail of a value that is made of both: varying if either is.
constexpr Detail joined(Detail a, Detail b) { return a == Detail::Varying ? a : b; }

} // namespace candela::sl
