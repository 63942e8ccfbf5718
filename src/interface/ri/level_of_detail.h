// SPDX-License-Identifier: Apache-2.0
// Which levels of detail are drawn (RI 3.2, 4.2.11).
#pragma once

#include "interface/ri/attributes.h"
#include "interface/ri/options.h"

namespace candela {

/// The paths that meet a primitive: those whose number in [0,1) lies in [from, until). Of two
/// primitives that are dissolved into each other every path meets one.
struct Presence {
    float from = 0, until = 1;

    bool isNone() const { return !(from < until); }
    bool isWhole() const { return from <= 0 && until >= 1; }
    bool operator==(const Presence &) const = default;
};

/// Of what has these attributes; `currentFromOuter`: where the outer space is of a detail that an
/// object has set.
Presence presenceOf(const Attributes &, const Matrix4 &currentFromOuter, const Options &);

} // namespace candela
