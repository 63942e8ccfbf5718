// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/blob_mesh.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <unordered_map>

namespace candela {

namespace {

/// The field is asked for in blocks of so many cells each way, of which few blobs reach into any.
constexpr int blockCells = 8;
constexpr int blockCorners = blockCells + 1;

/// Cells that the smallest blob is across, how many the surface may pass through, and in how many
/// blocks.
constexpr float cellsAcross = 32;
constexpr double mostCells = 1e6;
constexpr std::size_t mostBlocks = 100000;
/// Instructions that programs of blobs run for all corners of the grid together: some seconds.
constexpr double mostWork = 6e8;

using Cell = std::array<int, 3>;

std::uint64_t keyOf(const Cell &cell) {
    constexpr std::uint64_t offset = 1 << 20; // Of 21 bits, the sign apart.
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
        key = key << 21 | (std::uint64_t(cell[axis]) + offset);
    return key;
}

/// An edge of the grid that the surface crosses, at its lower end, and whether that is inside.
struct Crossing {
    Cell at;
    int axis;
    bool isOut;
};

/// A cube of 2^level blocks each way, and what there is of the field.
struct Part {
    Cell block;
    std::shared_ptr<const BlobField> near;
};

/// What one block finds.
struct BlockMesh {
    std::vector<Cell> cells;
    std::vector<Vec3> vertices, normals; ///< One a cell.
    std::vector<Crossing> crossings;
};

class Grid {
public:
    explicit Grid(const BlobField &field) : field_(field) {
        Box3 all;
        float smallest = INFINITY;
        for (const Blob &blob : field.blobs()) {
            all.add(blob.bound);
            const Vec3 extent = blob.bound.extent();
            smallest = std::min(smallest, std::min({extent.x, extent.y, extent.z}));
        }
        origin_ = all.low;
        size_ = smallest / cellsAcross;
        smallest_ = smallest;
        const Vec3 extent = all.extent();
        const float longest = std::max({extent.x, extent.y, extent.z});
        size_ = std::max(size_, longest / float(1 << 18));
        size_ = std::max(size_, float(std::sqrt(surfaceOfBlobs() / mostCells)));
        all_ = all;
        while (!findBlocks())
            size_ *= 1.3f;
    }

    float cellsAcrossSmallest() const { return smallest_ / size_; }

    /// The blocks that the surface may pass through, in an order of their own.
    std::span<const Part> blocks() const { return blocks_; }

    BlockMesh meshOf(const Part &part) const {
        const Cell first = firstCell(part.block);
        const BlobField near = part.near->within(boxOf(part.block, 0));
        std::vector<float> values(blockCorners * blockCorners * blockCorners);
        auto valueAt = [&](int x, int y, int z) -> float & {
            return values[std::size_t((z * blockCorners + y) * blockCorners + x)];
        };
        for (int z = 0; z < blockCorners; ++z)
            for (int y = 0; y < blockCorners; ++y)
                for (int x = 0; x < blockCorners; ++x)
                    valueAt(x, y, z) =
                        near.at(placeOf({first[0] + x, first[1] + y, first[2] + z})).value -
                        blobThreshold;
        BlockMesh mesh;
        for (int z = 0; z < blockCells; ++z)
            for (int y = 0; y < blockCells; ++y)
                for (int x = 0; x < blockCells; ++x)
                    addCell(near, first, {x, y, z}, valueAt, mesh);
        return mesh;
    }

private:
    /// About a quarter of that of the boxes in which they end.
    double surfaceOfBlobs() const {
        double area = 0;
        for (const Blob &blob : field_.blobs()) {
            const Vec3 e = blob.bound.extent();
            area += (double(e.x) * e.y + double(e.y) * e.z + double(e.z) * e.x) / 2;
        }
        return area;
    }

    static Cell firstCell(const Cell &block) {
        return {block[0] * blockCells, block[1] * blockCells, block[2] * blockCells};
    }

    Box3 boxOf(const Cell &block, int level) const {
        const Cell first = firstCell(block);
        Cell last = first;
        for (int &place : last)
            place += blockCells << level;
        return {placeOf(first), placeOf(last)};
    }

    /// From one cube around all to blocks, where the field may be the threshold. False if these are
    /// too many.
    bool findBlocks() {
        const Vec3 extent = all_.extent();
        const float longest = std::max({extent.x, extent.y, extent.z});
        int level = 0;
        while (float(blockCells << level) * size_ <= longest)
            ++level;
        std::vector<Part> parts{{{0, 0, 0}, std::make_shared<const BlobField>(field_)}};
        const auto costs = [&](double each) {
            double work = 0;
            for (const Part &part : parts)
                work += each * part.near->cost();
            return work;
        };
        double work = 0;
        const bool isOne = level == 0; // There is no coarser grid.
        for (; level > 0; --level) {
            constexpr double ofHalving = 8 * 3; // Halves; they are made, and bounded.
            if ((work += costs(ofHalving)) > mostWork)
                return false;
            std::vector<std::array<Part, 8>> halves(parts.size());
            parallelFor(parts.size(), [&](std::size_t i) { halve(parts[i], level, halves[i]); });
            parts.clear();
            for (const std::array<Part, 8> &each : halves)
                for (const Part &half : each)
                    if (half.near)
                        parts.push_back(half);
            if (parts.size() > mostBlocks)
                return false;
        }
        constexpr double ofMeshing = 2 * blockCorners * blockCorners * blockCorners;
        if ((work += costs(ofMeshing)) > mostWork && !isOne)
            return false;
        blocks_ = std::move(parts);
        return true;
    }

    /// Those of its halves each way that the surface may pass through have a field.
    void halve(const Part &part, int level, std::array<Part, 8> &halves) const {
        for (int k = 0; k < 8; ++k) {
            Cell block = part.block;
            for (int axis = 0; axis < 3; ++axis)
                block[axis] += (k >> axis & 1) << (level - 1);
            const Box3 box = boxOf(block, level - 1);
            auto near = std::make_shared<const BlobField>(part.near->within(box));
            const FieldBounds bounds = near->over(box);
            constexpr float rounding = 1e-3f;
            const bool isOut = bounds.high < blobThreshold - rounding;
            const bool isIn = bounds.low > blobThreshold + rounding;
            halves[k] = {block, isOut || isIn ? nullptr : std::move(near)};
        }
    }

    Vec3 placeOf(const Cell &corner) const {
        return origin_ + Vec3{float(corner[0]), float(corner[1]), float(corner[2])} * size_;
    }

    /// A vertex where the surface passes through the cell, and the crossings of the three edges at
    /// its lower corner.
    template <class ValueAt>
    void addCell(const BlobField &near, const Cell &first, const Cell &own, ValueAt valueAt,
                 BlockMesh &mesh) const {
        const Cell cell{first[0] + own[0], first[1] + own[1], first[2] + own[2]};
        auto at = [&](Cell corner) { return valueAt(corner[0], corner[1], corner[2]); };
        Vec3 sum;
        int crossings = 0;
        for (int axis = 0; axis < 3; ++axis)
            for (int side = 0; side < 4; ++side) {
                Cell low = own;
                low[(axis + 1) % 3] += side & 1, low[(axis + 2) % 3] += side >> 1;
                Cell high = low;
                ++high[axis];
                const float a = at(low), b = at(high);
                if ((a > 0) == (b > 0))
                    continue;
                if (side == 0)
                    mesh.crossings.push_back({cell, axis, a > 0});
                Vec3 place{float(low[0]), float(low[1]), float(low[2])};
                place[axis] += a / (a - b);
                sum += place, ++crossings;
            }
        if (crossings == 0)
            return;
        const Vec3 start = placeOf(first) + sum * (size_ / float(crossings));
        mesh.cells.push_back(cell);
        const Vec3 vertex = onto(near, start);
        mesh.vertices.push_back(vertex);
        mesh.normals.push_back(normalize(-near.at(vertex).gradient));
    }

    /// The place of the surface near this one: Newton's steps, of no more than a cell altogether.
    Vec3 onto(const BlobField &near, Vec3 start) const {
        Vec3 place = start;
        for (int step = 0; step < 4; ++step) {
            const FieldValue field = near.at(place);
            const float steep = dot(field.gradient, field.gradient);
            if (!(steep > 0))
                break;
            const Vec3 next = place - field.gradient * ((field.value - blobThreshold) / steep);
            if (!(length(next - start) < size_))
                break;
            place = next;
        }
        return place;
    }

    const BlobField &field_;
    Box3 all_;
    Vec3 origin_;
    float size_ = 1, smallest_ = 1;
    std::vector<Part> blocks_;
};

} // namespace

BlobMesh meshOf(const BlobField &field) {
    BlobMesh mesh;
    if (field.blobs().empty())
        return mesh;
    const Grid grid(field);
    mesh.cellsAcross = grid.cellsAcrossSmallest();
    const std::span<const Part> blocks = grid.blocks();
    std::vector<BlockMesh> parts(blocks.size());
    parallelFor(blocks.size(), [&](std::size_t i) { parts[i] = grid.meshOf(blocks[i]); });
    std::unordered_map<std::uint64_t, std::uint32_t> numberOf;
    for (const BlockMesh &part : parts)
        for (std::size_t i = 0; i < part.cells.size(); ++i) {
            numberOf[keyOf(part.cells[i])] = std::uint32_t(mesh.positions.size());
            mesh.positions.push_back(part.vertices[i]);
            mesh.normals.push_back(part.normals[i]);
        }
    // The four cells about a crossed edge make a quadrangle.
    for (const BlockMesh &part : parts)
        for (const Crossing &crossing : part.crossings) {
            const int b = (crossing.axis + 1) % 3, c = (crossing.axis + 2) % 3;
            std::array<std::uint32_t, 4> corner;
            bool complete = true;
            for (int k = 0; k < 4; ++k) {
                Cell cell = crossing.at;
                cell[b] -= k == 0 || k == 3, cell[c] -= k < 2;
                const auto found = numberOf.find(keyOf(cell));
                complete &= found != numberOf.end();
                corner[k] = complete ? found->second : 0;
            }
            if (!complete)
                continue;
            if (!crossing.isOut)
                std::swap(corner[1], corner[3]);
            auto apart = [&](int i, int j) {
                return length(mesh.positions[corner[i]] - mesh.positions[corner[j]]);
            };
            const int turn = apart(0, 2) <= apart(1, 3) ? 0 : 1;
            auto at = [&](int k) { return corner[(k + turn) % 4]; };
            mesh.triangles.push_back({at(0), at(1), at(2)});
            mesh.triangles.push_back({at(0), at(2), at(3)});
        }
    return mesh;
}

} // namespace candela
