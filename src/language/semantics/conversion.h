// SPDX-License-Identifier: Apache-2.0
// What an expression may be, and what it costs to make it something else. RI lets functions be
// overloaded by their result too, so an expression has a set of possible types until its context
// decides; the cheapest choice wins.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>

#include "language/semantics/type.h"

namespace candela::sl {

/// A set of base types.
class TypeSet {
public:
    TypeSet() = default;
    TypeSet(std::initializer_list<BaseType> types) {
        for (BaseType t : types)
            add(t);
    }

    void add(BaseType t) { bits_ |= 1u << int(t); }
    bool has(BaseType t) const { return bits_ >> int(t) & 1; }
    bool empty() const { return bits_ == 0; }
    bool isOnly(BaseType t) const { return bits_ == 1u << int(t); }
    bool hasGeometric() const;

    /// "float", "color or point", as messages name it.
    std::string text() const;

    /// Of an array: 0 otherwise.
    int arrayLength = 0;

private:
    unsigned bits_ = 0;
};

/// Costs are small integers; this one means: cannot be.
inline constexpr int impossible = 1000;

/// Of an implicit conversion: 0 for the same type, 1 among point, vector and normal, more for a
/// promotion of float. A colour is no point without a cast.
int conversionCost(BaseType from, BaseType to);
/// Of the best member of a set. An empty set (an error is known) costs nothing.
int conversionCost(const TypeSet &from, BaseType to);
/// Whether a cast may do it.
bool castable(BaseType from, BaseType to);
/// What an error about a conversion that cannot be may add: "; comp() takes one component", or "".
const char *conversionHint(BaseType from, BaseType to);

/// What a result costs in a context that wants a certain type (none: nothing).
int contextCost(BaseType result, std::optional<BaseType> wanted);

} // namespace candela::sl
