// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/blob_motion.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace candela {

namespace {

/// A blob, and what it has become.
struct MovingBlob {
    const Blob *from, *to;
    Matrix4 objectFromBlob; ///< Of what it has become.

    /// Where a point near it goes: as far along its segment, and as many radii away.
    Vec3 carry(Vec3 P) const {
        const auto [along, out] = from->placeOf(P);
        const Vec3 way = to->to - to->from;
        return transformPoint(objectFromBlob, to->from + way * along + out * to->radius);
    }
};

/// By leaf; null `from` where one of the two has no blob.
std::vector<MovingBlob> movingBlobs(const BlobField &from, const BlobField &to) {
    const std::vector<const Blob *> before = from.blobsOfLeaves(), after = to.blobsOfLeaves();
    std::vector<MovingBlob> blobs(before.size(), MovingBlob{nullptr, nullptr, {}});
    for (std::size_t leaf = 0; leaf < blobs.size(); ++leaf)
        if (before[leaf] && after[leaf])
            blobs[leaf] = {before[leaf], after[leaf],
                           inverse(after[leaf]->blobFromObject).value_or(Matrix4{})};
    return blobs;
}

/// Each blob takes along as much of a point as the field there is its own.
Vec3 carry(Vec3 P, std::span<const MovingBlob> blobs, std::span<const float> shares) {
    Vec3 sum;
    float all = 0;
    for (std::size_t leaf = 0; leaf < blobs.size(); ++leaf)
        if (blobs[leaf].from && shares[leaf] > 0)
            sum += blobs[leaf].carry(P) * shares[leaf], all += shares[leaf];
    return all > 0 ? sum / all : P;
}

float smallestExtent(const BlobField &field) {
    float smallest = std::numeric_limits<float>::infinity();
    for (const Blob &blob : field.blobs()) {
        const Vec3 extent = blob.bound.extent();
        smallest = std::min({smallest, extent.x, extent.y, extent.z});
    }
    return smallest;
}

/// Newton's steps to the surface, each no longer than `most`. False if they do not come there.
bool settle(const BlobField &field, float most, Vec3 &P, Vec3 &normal) {
    constexpr float near = 1e-4f;
    constexpr int steps = 24;
    for (int step = 0; step < steps; ++step) {
        const FieldValue at = field.at(P);
        const float steep = dot(at.gradient, at.gradient);
        if (!(steep > 0))
            return false;
        normal = at.gradient * (-1 / std::sqrt(steep));
        const float off = at.value - blobThreshold;
        if (std::fabs(off) < near)
            return true;
        P += normal * std::clamp(off / std::sqrt(steep), -most, most);
    }
    return false;
}

} // namespace

std::optional<BlobMesh> carriedTo(const BlobField &to, const BlobField &from,
                                  const BlobMesh &mesh) {
    if (to.blobs().empty() || to.leaves() != from.leaves())
        return std::nullopt;
    const std::vector<MovingBlob> blobs = movingBlobs(from, to);
    const float most = smallestExtent(to) / 16;
    BlobMesh carried = mesh;
    constexpr std::size_t part = 1024;
    std::atomic<std::size_t> lost = 0;
    parallelFor((mesh.positions.size() + part - 1) / part, [&](std::size_t number) {
        std::vector<float> shares(blobs.size());
        const std::size_t end = std::min((number + 1) * part, mesh.positions.size());
        for (std::size_t i = number * part; i < end; ++i) {
            from.sharesAt(mesh.positions[i], shares);
            carried.positions[i] = carry(mesh.positions[i], blobs, shares);
            lost += !settle(to, most, carried.positions[i], carried.normals[i]);
        }
    });
    constexpr double mostLost = 0.005;
    if (double(lost) > mostLost * double(mesh.positions.size()))
        return std::nullopt;
    return carried;
}

} // namespace candela
