// SPDX-License-Identifier: Apache-2.0
#include "world/displacement/displacement_bounds.h"

#include <cmath>
#include <fmt/format.h>

namespace candela {

namespace {

Matrix4 currentFrom(const std::string &space, const ShaderRecord &record,
                    const Matrix4 &currentFromShape,
                    const std::map<std::string, Matrix4> &systems) {
    if (space == "current" || space == "camera")
        return {};
    if (space == "shader")
        return record.currentFromShader.atOpen();
    const auto named = systems.find(space);
    return space == "object" || named == systems.end() ? currentFromShape : named->second;
}

} // namespace

DisplacementBounds::DisplacementBounds(const Attributes &attributes, const ShaderRecord &record,
                                       const Matrix4 &currentFromShape,
                                       const std::map<std::string, Matrix4> &systems)
    : shader_(record.name), where_(record.parameters.where) {
    if (const Parameter *given = attributes.named.find("displacementbound:sphere"))
        if (!given->floats.empty())
            bound_ = given->floats.front();
    space_ = attributes.named.string("displacementbound:coordinatesystem",
                                     attributes.named.string("displacementbound:space", "object"));
    spaceFromCurrent_ =
        inverse(currentFrom(space_, record, currentFromShape, systems)).value_or(Matrix4{});
}

void DisplacementBounds::moved(Vec3 way) {
    if (!bound_)
        return;
    const float far = length(transformVector(spaceFromCurrent_, way));
    float most = most_.load(std::memory_order_relaxed);
    while (far > most && !most_.compare_exchange_weak(most, far, std::memory_order_relaxed))
        continue;
}

void DisplacementBounds::report(DiagnosticSink &sink) const {
    if (astray_)
        sink.warning(where_, "shader \"" + shader_ +
                                 "\" moves points to where there is no place (infinite, or no "
                                 "numbers); they stay where they were");
    const float most = most_;
    if (bound_ && most > *bound_ * (1 + 1e-4f))
        sink.warning(where_,
                     fmt::format("shader \"{}\" moves points by up to {:.6g} in \"{}\" space, but "
                                 "the displacementbound is {:.6g}: nothing is cut off here, other "
                                 "renderers need at least {:.6g}",
                                 shader_, most, space_, *bound_, most));
}

} // namespace candela
