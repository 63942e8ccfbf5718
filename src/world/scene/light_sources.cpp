// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_sources.h"

#include <algorithm>

namespace candela {

namespace {

SourceBin binOf(const SceneLight &light, const LightElement &element, const PointTables &points) {
    using Asked = SourceBin::Asked;
    SourceBin bin;
    bin.castsShadow = light.castsShadow, bin.si = light.si;
    bin.distant = light.kind == LightKind::Distant;
    bin.isSky = light.sky && light.castsShadow;
    const std::int32_t appearance =
        light.hasGeometry() ? points.appearanceOf(element.instance, element.shape) : 0;
    if (light.finite() && points.details[appearance].attributes->sides == 1)
        bin.frontSign = points.appearances[appearance].elementSign < 0 ? -1.0f : 1.0f;
    if (light.finite() && !(light.plain && light.kind == LightKind::Area)) {
        bin.asked = Asked::Surface;
        bin.surfaceCode = points.appearances[appearance].code;
        return bin;
    }
    bin.shader = light.shader.code.get();
    if (light.hasGeometry()) {
        bin.asked = light.finite() ? Asked::PlainShader : Asked::ClassicArea;
        bin.elementSign = points.appearances[appearance].elementSign;
    }
    return bin;
}

} // namespace

int chooseByCumulative(std::span<const double> cumulative, double &sample) {
    if (cumulative.size() == 1)
        return 0;
    auto place = std::upper_bound(cumulative.begin(), cumulative.end(), sample);
    if (place == cumulative.end())
        --place;
    double below = place == cumulative.begin() ? 0 : place[-1];
    // Entries without a share can only be reached by rounding at the end of the table.
    while (*place <= below && place != cumulative.begin()) {
        --place;
        below = place == cumulative.begin() ? 0 : place[-1];
    }
    sample = std::clamp((sample - below) / (*place - below), 0.0, 0x1.fffffffffffffp-1);
    return int(place - cumulative.begin());
}

std::int32_t LightTable::drawElement(const LightSource &source, float &sample) const {
    if (source.members == 1)
        return members[source.firstMember];
    double rest = sample;
    const int member = chooseByCumulative(
        {memberShares.data() + source.firstMember, std::size_t(source.members)}, rest);
    sample = std::min(float(rest), 0x1.fffffep-1f);
    return members[source.firstMember + member];
}

void LightTable::number(const PointTables &points) {
    ambient.clear(), bins.clear();
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].kind == LightKind::Ambient)
            ambient.push_back(int(i));
    int last = -1;
    for (LightSource &source : sources) {
        const SourceBin bin = binOf(lights[source.light], firstElementOf(source), points);
        if (last < 0 || !(bins[last] == bin)) { // Neighbours mostly share one.
            last = int(std::ranges::find(bins, bin) - bins.begin());
            if (last == int(bins.size()))
                bins.push_back(bin);
        }
        source.bin = last;
    }
}

} // namespace candela
