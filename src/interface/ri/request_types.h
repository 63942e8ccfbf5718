// SPDX-License-Identifier: Apache-2.0
// The types that stand in requests.def as arguments of requests.
#pragma once

#include "foundation/base/diagnostics.h"
#include "foundation/base/matrix4.h"
#include "foundation/units/color.h"

#include <array>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace candela {

using Floats = std::vector<float>;
using Integers = std::vector<int>;
using Strings = std::vector<std::string>;

/// As many numbers as the user gave, none included, with or without brackets.
struct LooseFloats {
    Floats values;
};

/// Names a light or an object. RIB writes an integer or a string; an integer is kept as its text.
struct Handle {
    std::string text;
};

/// RiBasis takes the name of a standard basis or sixteen numbers.
using BasisArgument = std::variant<std::string, std::array<float, 16>>;

/// The optional tags of a SubdivisionMesh.
struct SubdivisionTags {
    Strings names;
    Integers argumentCounts, integers;
    Floats floats;
};

/// A token as the user wrote it ("Kd", or with its declaration "uniform float Kd") and its
/// values, not yet checked against a declaration.
struct TokenValue {
    std::string token;
    SourceLocation where;
    Floats floats; ///< Numbers, or
    Strings strings;
    /// The same numbers, if all are whole and a float cannot hold one of them; else nothing.
    Integers integers = {};
};

/// The parameter list at the end of a request.
struct TokenList {
    std::vector<TokenValue> all;
};

/// How a handler receives an argument of type T.
template <class T> using Pass = std::conditional_t<std::is_arithmetic_v<T>, T, const T &>;

} // namespace candela
