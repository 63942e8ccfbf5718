// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/declarations.h"
#include "world/texture/textures.h"

namespace candela {

namespace {

std::vector<float> listOf(const std::optional<Matrix4> &matrix) {
    return matrix ? std::vector<float>(matrix->m.begin(), matrix->m.end()) : std::vector<float>{};
}

/// The frame, whose corners are (0,0) and (1,1), as a screen from (-1,-1), below on the left.
std::optional<Matrix4> screenOf(std::optional<Matrix4> frame) {
    for (int row = 0; frame && row < 4; ++row) {
        frame->at(row, 0) = 2 * frame->at(row, 0) - frame->at(row, 3);
        frame->at(row, 1) = frame->at(row, 3) - 2 * frame->at(row, 1);
    }
    return frame;
}

std::vector<float> factNamed(const PictureFacts &facts, bool exists, std::string_view fact) {
    if (fact == "exists")
        return {exists ? 1.0f : 0.0f};
    if (!exists)
        return {};
    if (fact == "resolution")
        return {float(facts.width), float(facts.height)};
    if (fact == "channels")
        return {float(facts.channels)};
    if (fact == "viewingmatrix")
        return listOf(facts.cameraFromWorld);
    if (fact == "projectionmatrix")
        return listOf(screenOf(facts.frameFromWorld));
    return {};
}

} // namespace

std::vector<float> textureFact(const PictureFacts &facts, bool exists, std::string_view fact,
                               std::string_view type) {
    const auto wanted = parseDeclaration(type);
    std::vector<float> values = factNamed(facts, exists, fact);
    const bool isMatrix = wanted && wanted->type == ValueType::Matrix && wanted->arraySize == 1;
    const bool fits =
        wanted && (isMatrix ? values.size() == 16
                            : wanted->type == ValueType::Float &&
                                  values.size() == std::size_t(std::max(1, wanted->arraySize)));
    return fits ? values : std::vector<float>{};
}

} // namespace candela
