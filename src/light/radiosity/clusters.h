// SPDX-License-Identifier: Apache-2.0
// Clusters: faces that exchange light together with what is far away (Smits, Arvo and Greenberg
// 1994; Sillion 1995), so that links grow with the elements and not with their square. What a
// cluster sends, and what it receives, is known by direction in spherical harmonics up to the
// second order, which tell irradiance of any normal within a few hundredths (Ramamoorthi and
// Hanrahan 2001).
#pragma once

#include "light/radiosity/fields.h"

namespace candela::radiosity {

inline constexpr int harmonics = 9;
/// Y_lm of a unit vector, l from 0 to 2.
std::array<float, harmonics> harmonicsOf(Vec3);

/// A function of direction, a colour.
struct Directional {
    std::array<Color, harmonics> coefficients{};

    void add(Vec3 direction, const Color &value);
    void add(const Directional &, const Color &factor);
    /// Convolved with the clamped cosine.
    Color cosineAt(Vec3 normal) const;
};

struct Cluster {
    std::int32_t firstChild = -1;           ///< Two in a row; -1: it holds faces.
    std::uint32_t firstFace = 0, faces = 0; ///< In ClusterTree::order.
    Vec3 centre;
    float radius = 0;
    float area = 0;
};

class ClusterTree {
public:
    explicit ClusterTree(const Mesh &);

    std::span<const Cluster> clusters() const { return clusters_; } ///< The first is all.
    /// Root elements, cluster by cluster.
    std::span<const int> rootsOf(int cluster) const {
        const Cluster &own = clusters_[std::size_t(cluster)];
        return std::span(order_).subspan(own.firstFace, own.faces);
    }

    /// By cluster: radiant exitance times area over pi, by the normals it leaves; cosineAt() of it
    /// is radiant intensity, W sr^-1.
    std::vector<Directional> sent(const Mesh &, const std::vector<Color> &exitance) const;
    /// By cluster: all that is sent, W.
    std::vector<Color> power(const Mesh &, const std::vector<Color> &exitance) const;
    /// Adds to the roots' irradiance what clusters have received: irradiance of faces that look
    /// into each direction, by the directions that it comes from.
    void distribute(const Mesh &, std::vector<Directional> received,
                    std::vector<Color> &irradiance) const;

private:
    int build(const Mesh &, std::size_t first, std::size_t last, std::size_t fronts, int at);
    void split(const Mesh &, std::size_t first, std::size_t middle, std::size_t last, Vec3 size);

    std::vector<Cluster> clusters_;
    std::vector<int> order_;
};

} // namespace candela::radiosity
