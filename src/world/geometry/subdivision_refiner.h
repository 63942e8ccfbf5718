// SPDX-License-Identifier: Apache-2.0
// Subdivision meshes as OpenSubdiv has them: for the files that refine them alone.
#pragma once

#include "interface/ri/primitive_record.h"

#include <opensubdiv/far/topologyRefiner.h>

#include <memory>
#include <string>

namespace candela {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

/// One component, as OpenSubdiv sums it up.
struct Sum {
    double value = 0;
    void Clear(void * = nullptr) { value = 0; }
    void AddWithWeight(const Sum &other, double weight) { value += weight * other.value; }
};

/// Sharpness from which edges stay sharp for ever.
constexpr float infinitelySharp = 10; // Sdc::Crease::SHARPNESS_INFINITE is no constant expression.

/// Null, and a sentence, if the mesh is no surface. The record's numbers must be within bounds.
std::unique_ptr<Far::TopologyRefiner> refinerOf(const SubdivisionRecord &, int vertices,
                                                std::string &why);

/// Splits until creases and corners that are not sharp for ever have gone.
int levelsOfCreases(const SubdivisionRecord &);

/// Creases along what is no edge, which have no effect.
int strayCreasesOf(const SubdivisionRecord &, const Far::TopologyRefiner &);

} // namespace candela
