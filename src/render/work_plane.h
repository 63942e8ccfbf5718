// SPDX-License-Identifier: Apache-2.0
// A grid of points over a parallelogram: the work plane of lighting design.
#pragma once

#include "image/picture.h"
#include "light/probe/probe.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// Points are the middles of columns x rows cells. Rows begin at the far end of v, so that a table
/// or a picture has u to the right and v upwards. Sensors face along u x v (of coordinates as they
/// are), or against it.
struct WorkPlane {
    std::array<double, 3> corner{}, u{}, v{}; ///< World space; u and v are edges.
    int columns = 1, rows = 1;
    bool turned = false;

    /// Row by row; numbered from 1.
    std::vector<ProbePoint> points() const;
    /// What is wrong with the edges; empty if nothing is.
    std::string flaw() const;
};

/// The photometric values as people read them: a row a line, and their mean, least and largest.
std::string tableOf(const WorkPlane &, ProbeQuantity, std::span<const ProbeAnswer>);

/// R, G, B in W m^-2 (W m^-2 sr^-1), "illuminance" in lx ("luminance" in cd m^-2), "halfwidth"
/// of its interval and "samples".
Picture pictureOf(const WorkPlane &, ProbeQuantity, std::span<const ProbeAnswer>);

/// The same colours, in cells of so many pixels that a legend has room beside them, and that the
/// cells are as they are on the plane.
Picture enlarged(const WorkPlane &, const Picture &);

} // namespace candela
