// SPDX-License-Identifier: Apache-2.0
// Things that tests displace themselves, point by point.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

struct DenseScene {
    std::string name;
    std::string plain; ///< RIB of the thing itself,
    std::string
        dense; ///< and of many triangles where "waves" moves its points, with their normals.
};
std::vector<DenseScene> denseScenes();

} // namespace candela::test
