// SPDX-License-Identifier: Apache-2.0
#include "world/texture/cube_faces.h"

#include "foundation/base/parallel.h"
#include "world/texture/lat_long.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

struct FaceAxes {
    Vec3 forward, up, right;
};
constexpr FaceAxes axes[6] = {
    {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 1, 0}, {0, 0, -1}, {1, 0, 0}}, {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
    {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}},  {{0, 0, -1}, {0, 1, 0}, {-1, 0, 0}},
};

/// Lookups across and down a pixel of the result.
constexpr int samples = 3;
constexpr int mostColumns = 16384;

int faceOf(const Vec3 &direction) {
    int best = 0;
    for (int face = 1; face < 6; ++face)
        if (dot(direction, axes[face].forward) > dot(direction, axes[best].forward))
            best = face;
    return best;
}

/// Between the four pixels around (x, y), which counts from the upper left corner; the border goes
/// on.
void addBetween(const PictureData &face, float x, float y, float weight, float *to) {
    const int width = face.facts.width, height = face.facts.height, n = face.facts.channels;
    x = std::clamp(x - 0.5f, 0.0f, float(width - 1)),
    y = std::clamp(y - 0.5f, 0.0f, float(height - 1));
    const int column = std::min(int(x), std::max(0, width - 2));
    const int row = std::min(int(y), std::max(0, height - 2));
    const float right = x - float(column), below = y - float(row);
    for (int corner = 0; corner < 4; ++corner) {
        const int dx = corner & 1, dy = corner >> 1;
        const float part = weight * (dx ? right : 1 - right) * (dy ? below : 1 - below);
        const std::size_t pixel = std::size_t(std::min(row + dy, height - 1)) * std::size_t(width) +
                                  std::size_t(std::min(column + dx, width - 1));
        for (int c = 0; c < n; ++c)
            to[c] += part * face.values[pixel * std::size_t(n) + std::size_t(c)];
    }
}

void addDirection(const std::array<PictureData, 6> &faces, const Vec3 &direction, float halfWidth,
                  float weight, float *to) {
    const int number = faceOf(direction);
    const PictureData &face = faces[std::size_t(number)];
    const FaceAxes &at = axes[number];
    const float scale = 1 / (dot(direction, at.forward) * halfWidth);
    addBetween(face, (1 + dot(direction, at.right) * scale) / 2 * float(face.facts.width),
               (1 - dot(direction, at.up) * scale) / 2 * float(face.facts.height), weight, to);
}

} // namespace

std::optional<PictureData> latLongOfFaces(const std::array<PictureData, 6> &faces,
                                          float fieldOfView, std::string &problem) {
    const PictureFacts &first = faces[0].facts;
    for (const PictureData &face : faces)
        if (face.facts.width != first.width || face.facts.height != first.height ||
            face.facts.channels != first.channels) {
            problem = "the six faces do not have the same size and number of channels";
            return std::nullopt;
        }
    const float halfWidth = std::tan(fieldOfView * std::numbers::pi_v<float> / 360);
    PictureData result;
    PictureFacts &facts = result.facts;
    facts.kind = PictureKind::Environment;
    facts.width = int(std::clamp(4 * float(first.width) / halfWidth, 4.0f, float(mostColumns)));
    facts.height = facts.width / 2, facts.channels = first.channels;
    facts.frameWidth = facts.width, facts.frameHeight = facts.height;
    const std::size_t rowValues = std::size_t(facts.width) * std::size_t(facts.channels);
    result.values.resize(rowValues * std::size_t(facts.height));
    parallelFor(std::size_t(facts.height), [&](std::size_t row) {
        for (int column = 0; column < facts.width; ++column)
            for (int k = 0; k < samples * samples; ++k) {
                const float s =
                    (float(column) + (float(k % samples) + 0.5f) / samples) / float(facts.width);
                const float t =
                    (float(row) + (float(k / samples) + 0.5f) / samples) / float(facts.height);
                addDirection(faces, latLongDirection(s, t), halfWidth, 1.0f / (samples * samples),
                             result.values.data() + row * rowValues +
                                 std::size_t(column) * std::size_t(facts.channels));
            }
    });
    return result;
}

} // namespace candela
