// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/solution_mesh.h"

#include "foundation/base/raw_bytes.h"

#include <algorithm>
#include <numbers>

namespace candela::radiosity {

namespace {

class PlyWriter {
public:
    PlyWriter(const Solution &solution, const Matrix4 &worldFromCurrent)
        : mesh_(solution.mesh()), fields_(solution.fields()), worldFromCurrent_(worldFromCurrent),
          currentFromWorld_(inverse(worldFromCurrent).value_or(Matrix4{})) {}

    std::string write() {
        for (int e = 0; e < mesh_.size(); ++e)
            if (mesh_.element(e).firstChild < 0 && isShown(e))
                add(e);
        return header() + vertices_ + faces_;
    }

private:
    bool isShown(int e) const {
        if (!mesh_.faceOf(e).isBack)
            return true;
        for (std::size_t i = 0; i < mesh_.nodes(e).size(); ++i)
            if (brightest(exitanceAt(first(e) + i)) > 0)
                return true;
        return false;
    }

    void add(int e) {
        const Element &element = mesh_.element(e);
        const Basis &basis = mesh_.basis(e);
        const std::span<const Place> corners = Basis::corners(basis.isTriangle());
        Vec3 normal = transformNormal(currentFromWorld_, element.normal);
        normal = normal / std::max(length(normal), 1e-30f);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Vec3 P = transformPoint(worldFromCurrent_, element.corners[k]);
            for (const Vec3 &v : {P, normal})
                for (const float component : {v.x, v.y, v.z})
                    appendRaw(vertices_, component);
            float value[mostNodes];
            basis.values(corners[k], value);
            Color radiance{};
            for (std::size_t i = 0; i < mesh_.nodes(e).size(); ++i)
                for (std::size_t c = 0; c < colorSamples; ++c)
                    radiance[c] += value[i] * exitanceAt(first(e) + i)[c];
            for (const float exitance : radiance)
                appendRaw(vertices_, std::max(exitance, 0.0f) / std::numbers::pi_v<float>);
        }
        appendRaw(faces_, std::uint8_t(corners.size()));
        const bool isTurned = element.turned < 0;
        for (std::size_t k = 0; k < corners.size(); ++k)
            appendRaw(faces_, std::int32_t(vertexCount_ + (isTurned ? corners.size() - 1 - k : k)));
        vertexCount_ += corners.size();
        ++faceCount_;
    }

    std::size_t first(int e) const { return std::size_t(e) * std::size_t(mesh_.stride()); }
    Color exitanceAt(std::size_t node) const {
        Color sum = fields_.exitance[node];
        for (std::size_t c = 0; c < colorSamples; ++c)
            sum[c] += fields_.emission[node][c];
        return sum;
    }

    std::string header() const {
        std::string text = "ply\nformat binary_little_endian 1.0\n"
                           "comment radiosity of Candela: radiance in W m^-2 sr^-1\n"
                           "element vertex " +
                           std::to_string(vertexCount_) + "\n";
        for (const char *name : {"x", "y", "z", "nx", "ny", "nz", "red", "green", "blue"})
            text += "property float " + std::string(name) + "\n";
        return text + "element face " + std::to_string(faceCount_) +
               "\nproperty list uchar int vertex_indices\nend_header\n";
    }

    const Mesh &mesh_;
    const Fields &fields_;
    const Matrix4 worldFromCurrent_, currentFromWorld_;
    std::string vertices_, faces_;
    std::size_t vertexCount_ = 0, faceCount_ = 0;
};

} // namespace

std::string plyOf(const Solution &solution, const Matrix4 &worldFromCurrent) {
    return PlyWriter(solution, worldFromCurrent).write();
}

} // namespace candela::radiosity
