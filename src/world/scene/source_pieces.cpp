// SPDX-License-Identifier: Apache-2.0
#include "world/scene/source_pieces.h"

#include "world/scene/source_geometry.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace candela {

namespace {

/// Pieces of so many elements are cut no further.
constexpr std::size_t fewElements = 8;
/// Normals that differ by a unit count as so much of the shape's extent.
constexpr float normalWeight = 0.25f;

/// Cuts where the elements' places and normals, six coordinates, spread most.
class Cutter {
public:
    explicit Cutter(std::span<const LightElement> triangles) {
        Box3 box;
        for (const LightElement &triangle : triangles)
            box.add(middleOf(triangle));
        const float extent = length(box.extent()), scale = extent > 0 ? 1 / extent : 0;
        for (const LightElement &triangle : triangles) {
            const Vec3 place = middleOf(triangle) * scale;
            const Vec3 normal = normalize(cross(triangle.edgeA, triangle.edgeB)) * normalWeight;
            places_.push_back({place.x, place.y, place.z, normal.x, normal.y, normal.z});
            areas_.push_back(areaOf(triangle));
        }
        pieces_.order.resize(triangles.size());
        std::iota(pieces_.order.begin(), pieces_.order.end(), 0u);
    }

    Pieces run() {
        cut(0, pieces_.order.size(), mostPieces);
        return std::move(pieces_);
    }

private:
    static Vec3 middleOf(const LightElement &triangle) {
        return triangle.corner + (triangle.edgeA + triangle.edgeB) * (1 / 3.0f);
    }

    void cut(std::size_t first, std::size_t last, int pieces) {
        if (pieces == 1 || last - first <= fewElements) {
            pieces_.ends.push_back(std::uint32_t(last));
            return;
        }
        const int widest = widestOf(first, last);
        std::sort(pieces_.order.begin() + first, pieces_.order.begin() + last,
                  [&](std::uint32_t a, std::uint32_t b) {
                      return std::pair(places_[a][widest], a) < std::pair(places_[b][widest], b);
                  });
        const std::size_t middle = cutOf(first, last, widest);
        cut(first, middle, pieces / 2);
        cut(middle, last, pieces / 2);
    }

    int widestOf(std::size_t first, std::size_t last) const {
        std::array<float, 6> low = places_[pieces_.order[first]], high = low;
        for (std::size_t k = first; k < last; ++k)
            for (int c = 0; c < 6; ++c) {
                low[c] = std::min(low[c], places_[pieces_.order[k]][c]);
                high[c] = std::max(high[c], places_[pieces_.order[k]][c]);
            }
        int widest = 0;
        for (int c = 1; c < 6; ++c)
            if (high[c] - low[c] > high[widest] - low[widest])
                widest = c;
        return widest;
    }

    /// In the middle of the spread, if each side then has a quarter of the area; neither is empty.
    std::size_t cutOf(std::size_t first, std::size_t last, int axis) const {
        auto at = [&](std::size_t k) { return places_[pieces_.order[k]][axis]; };
        const float middle = (at(first) + at(last - 1)) / 2;
        double total = 0, sum = 0;
        for (std::size_t k = first; k < last; ++k)
            total += areas_[pieces_.order[k]];
        for (std::size_t k = first; k + 1 < last; ++k) {
            sum += areas_[pieces_.order[k]];
            if (sum >= total * 3 / 4 || (sum >= total / 4 && at(k + 1) > middle))
                return k + 1;
        }
        return last - 1;
    }

    std::vector<std::array<float, 6>> places_;
    std::vector<double> areas_;
    Pieces pieces_;
};

} // namespace

Pieces cutToPieces(std::span<const LightElement> triangles) {
    return triangles.empty() ? Pieces{} : Cutter(triangles).run();
}

} // namespace candela
