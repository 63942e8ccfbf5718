// SPDX-License-Identifier: Apache-2.0
#include "world/shading/light_categories.h"

#include <algorithm>

namespace candela {

LightCategories::LightCategories(const std::vector<ir::LightRequest> &requests) {
    for (const ir::LightRequest &request : requests)
        if (request.kind == ir::LightRequest::Kind::Loop)
            loops_.push_back(request.category);
}

void LightCategories::bind(std::vector<std::uint8_t> accepts, int lightCount) {
    accepts_ = std::move(accepts);
    lightCount_ = lightCount;
    const std::size_t row = std::size_t(lightCount) + 1;
    hearsAsIndirect_.assign(row, 1);
    for (std::size_t first = 0; first < accepts_.size(); first += row)
        for (std::size_t light = 0; light < row; ++light)
            hearsAsIndirect_[light] &= accepts_[first + light] == accepts_[first];
    if (std::ranges::find(hearsAsIndirect_, 0) == hearsAsIndirect_.end())
        hearsAsIndirect_.clear();
    if (std::ranges::find(accepts_, 0) == accepts_.end())
        accepts_.clear(); // What accepts everything need not be asked.
}

void LightCategories::leaveLightsToSamples(int lightCount) {
    hearsAsIndirect_.assign(std::size_t(lightCount) + 1, 0);
    hearsAsIndirect_[0] = 1;
}

bool LightCategories::hears(std::int32_t light) const {
    const std::size_t row = std::size_t(lightCount_) + 1;
    const auto accepts = [&](int category) {
        return category < 0 || accepts_.empty() || accepts_[category * row + light] != 0;
    };
    return loops_.empty() || std::ranges::any_of(loops_, accepts);
}

void LightCategories::bind(ShaderArgs &args) const {
    args.categoryAccepts = accepts_.empty() ? nullptr : accepts_.data();
    args.lightCount = lightCount_;
}

} // namespace candela
