// SPDX-License-Identifier: Apache-2.0
#include "world/displacement/displacement_bounds.h"

#include <algorithm>
#include <fmt/format.h>
#include <set>
#include <tuple>

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

DisplacementBounds::DisplacementBounds(const Attributes &attributes,
                                       std::shared_ptr<const ShaderRecord> record,
                                       const Matrix4 &currentFromShape,
                                       const std::map<std::string, Matrix4> &systems)
    : record_(std::move(record)) {
    if (const Parameter *given = attributes.named.find("displacementbound:sphere"))
        if (!given->floats.empty())
            bound_ = given->floats.front();
    space_ = attributes.named.string("displacementbound:coordinatesystem",
                                     attributes.named.string("displacementbound:space", "object"));
    spaceFromCurrent_ =
        inverse(currentFrom(space_, *record_, currentFromShape, systems)).value_or(Matrix4{});
}

void DisplacementBounds::moved(Vec3 way) {
    if (!bound_)
        return;
    const float far = length(transformVector(spaceFromCurrent_, way));
    float most = most_.load(std::memory_order_relaxed);
    while (far > most && !most_.compare_exchange_weak(most, far, std::memory_order_relaxed))
        continue;
}

void DisplacementBounds::report(std::span<const std::shared_ptr<DisplacementBounds>> all,
                                DiagnosticSink &sink) {
    // In the order of the shapes; by what the file says that is too small.
    std::set<const ShaderRecord *> told;
    std::map<std::tuple<const ShaderRecord *, std::string, float>, float> least;
    for (const auto &bounds : all) {
        float &most = least[{bounds->record_.get(), bounds->space_, bounds->bound_.value_or(0)}];
        most = std::max<float>(most, bounds->most_);
    }
    for (const auto &bounds : all) {
        const ShaderRecord &record = *bounds->record_;
        if (bounds->astray_ && told.insert(&record).second)
            sink.warning(
                record.parameters.where,
                "shader \"" + record.name +
                    "\" moves points to where there is no place (infinite, or no numbers); "
                    "they stay where they were");
        float &most = least[{&record, bounds->space_, bounds->bound_.value_or(0)}];
        if (bounds->bound_ && most > *bounds->bound_ * (1 + 1e-4f))
            sink.warning(
                record.parameters.where,
                fmt::format("shader \"{}\" moves points by up to {:.6g} in \"{}\" space, "
                            "but the displacementbound is {:.6g}: nothing is cut off here, "
                            "other renderers need at least {:.6g}",
                            record.name, most, bounds->space_, *bounds->bound_, most));
        most = 0; // It is told.
    }
}

} // namespace candela
