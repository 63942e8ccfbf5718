// SPDX-License-Identifier: Apache-2.0
// What a solution tells of points that rays have met.
#include "light/radiosity/solution.h"

#include <algorithm>

namespace candela::radiosity {

/// A point on one side of a surface.
struct Solution::Asked {
    int vertex;
    bool isBehind;
    std::int32_t face;
    Place place;
    Vec3 P, N;
};

/// Light that varies faster than elements do, of links to the leaf and to all above it.
void Solution::addNear(const Asked &asked, const NodeWeights &weights, const Answering &answering,
                       Color &sum) const {
    if (weights.leaf < 0)
        return;
    std::array<float, mostNodes> value;
    weights.ofLeaf(mesh_.stride(), value.data());
    for (int e = weights.leaf; e >= 0; e = mesh_.element(e).parent) {
        if (!answering.near.isAt(e))
            continue;
        if (e != weights.leaf)
            mesh_.basis(e).values(Mesh::inElement(mesh_.element(e), asked.place), value.data());
        answering.near.add(mesh_, e, value.data(), asked.P, asked.N, sum);
    }
}

void Solution::answer(const Asked &asked, const NodeWeights &weights, const Answer &answer) const {
    const auto add = [&](const std::vector<Color> &field, Color &sum) {
        for (std::size_t i = 0; i < std::size_t(weights.count); ++i)
            for (std::size_t k = 0; k < colorSamples; ++k)
                sum[k] += weights.weight[i] * field[std::size_t(weights.node[i])][k];
    };
    const auto addExchanged = [&](const std::vector<Color> &told, const Answering &answering,
                                  Color &sum) {
        add(answer.isExact ? answering.smooth : told, sum);
        if (!answer.isExact)
            return;
        Color near{};
        addNear(asked, weights, answering, near);
        float factor = 0;
        for (std::size_t i = 0; i < std::size_t(weights.count); ++i)
            factor += weights.weight[i] * answering.factor[std::size_t(weights.node[i])];
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += factor * near[k];
    };
    const auto put = [&](const Color &found, const std::array<float *, colorSamples> &to) {
        for (std::size_t k = 0; k < colorSamples; ++k)
            to[k][asked.vertex] = std::max(found[k], 0.0f);
    };
    const auto &direct = asked.isBehind ? answer.directBehind : answer.direct;
    const auto &indirect = asked.isBehind ? answer.indirectBehind : answer.indirect;
    if (direct[0]) {
        Color sum{};
        add(fields_.direct, sum);
        addExchanged(fields_.lamps, lamps_, sum);
        put(sum, direct);
    }
    if (indirect[0]) {
        Color sum{};
        addExchanged(fields_.indirect, indirect_, sum);
        put(sum, indirect);
    }
}

void Solution::irradiance(SurfaceVertices &vertices, const Answer &answer) const {
    const int count = vertices.count();
    thread_local std::vector<std::uint32_t> piece;
    thread_local std::vector<float> u, v;
    thread_local std::vector<Asked> asked;
    thread_local PlaceLookup lookup;
    piece.resize(std::size_t(count)), u.resize(std::size_t(count)), v.resize(std::size_t(count));
    mesh_.scene().domains().name(vertices.points, piece.data(), u.data(), v.data());
    const ConstVec3Planes P = vertices.P(), facing = vertices.facingPlanes();
    const auto get = [](const ConstVec3Planes &planes, int i) {
        return Vec3{planes[0][i], planes[1][i], planes[2][i]};
    };
    asked.clear(), lookup.clear();
    const auto ask = [&](int i, bool isBehind) {
        const bool isBack = vertices.isMetFromInside(i) != isBehind;
        const std::int32_t face = mesh_.faceAt(
            vertices.points.instance[i], vertices.points.shape[i], piece[std::size_t(i)], isBack);
        const Place place{u[std::size_t(i)], v[std::size_t(i)]};
        asked.push_back(
            {i, isBehind, face, place, get(P, i), isBehind ? -get(facing, i) : get(facing, i)});
        lookup.add(mesh_, face, place, get(P, i));
    };
    for (int i = 0; i < count; ++i) {
        if (answer.direct[0] || answer.indirect[0])
            ask(i, false);
        if (answer.directBehind[0] || answer.indirectBehind[0])
            ask(i, true);
    }
    lookup.find(mesh_);
    for (std::size_t k = 0; k < asked.size(); ++k)
        this->answer(asked[k], lookup[int(k)], answer);
}

} // namespace candela::radiosity
