// SPDX-License-Identifier: Apache-2.0
// What a solution is beside the scene's surfaces: numbers that a file may keep. They know elements
// by their numbers alone, and hold wherever the camera stands.
#pragma once

#include "light/radiosity/fields.h"
#include "light/radiosity/near_light.h"
#include "light/radiosity/settings.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candela::radiosity {

struct SolutionData {
    int order = 2;                     ///< Basis.
    std::uint64_t roots = 0;           ///< Elements that nothing has divided.
    std::vector<std::int32_t> divided; ///< Elements, in the order in which they were.
    /// As Fields has them; `smooth` is without what comes by the records of near light.
    std::vector<Color> direct, lamps, smoothLamps, emission;
    std::vector<Color> indirect, smoothIndirect, exitance;
    std::vector<NearRecord> nearLamps, nearIndirect;
    std::vector<float> factorOfLamps, factorOfIndirect; ///< By node, of near light.
    SolverStatistics statistics;

    int elements() const { return int(roots) + Basis::children * int(divided.size()); }
};

/// Of use to machines of the same byte order.
std::string bytesOf(const SolutionData &);
/// Nothing if the bytes are no such data, or name elements that there are not.
std::optional<SolutionData> solutionOf(std::string_view bytes);

} // namespace candela::radiosity
