// SPDX-License-Identifier: Apache-2.0
// Elements: the sides of the scene's surfaces, divided into four again and again in their own
// parameters. An element knows the points of its basis's rule on the true surface.
#pragma once

#include "light/radiosity/basis.h"
#include "world/scene/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela::radiosity {

/// One side of a piece of a placed shape.
struct Face {
    std::uint32_t domain = 0, piece = 0;
    bool isBack = false;
    std::int32_t opposite = -1; ///< The face of the other side, -1 where rays do not meet it.
    std::int32_t root = -1;     ///< Its element; -1 = it has no area, or is a sky.
};

struct Element {
    std::uint32_t face = 0;
    std::int32_t parent = -1, firstChild = -1; ///< Four in a row; -1 = a leaf.
    Place origin;                              ///< The element's (u,v) in the face's:
    float scale = 1;                           ///< origin + scale (u,v).
    float area = 0;
    int level = 0;
    Vec3 centre, normal;         ///< Normals lie on the face's side.
    std::array<Vec3, 4> corners; ///< In order around it; of triangles three.
    float radius = 0;            ///< Of a sphere about the centre.
    float turned = 1;            ///< -1: seen from the face's side the corners go the other way.
    /// Its vector area, over that of the polygon of its corners: what curved edges add.
    float fullness = 1;
    bool isFlat = true;  ///< No part of it sees another.
    bool isPlane = true; ///< And its normals are the same.
    bool isCut = false;  ///< Something stands on it, and what is on either side is apart (cuts.h).
    std::int32_t sides = -1; ///< Of cut elements with children: Mesh::sides().
    bool isTorn = false;     ///< Of these: some side has none of its own nodes.
};

/// Of a cut element: on whose side each node of its children is, at child times mostNodes + node:
/// the nearest of its own nodes that nothing hides from it; -1 = of none.
using Sides = std::array<std::int8_t, Basis::children * mostNodes>;

struct Node {
    Vec3 P, N;
    float area = 0; ///< Of the surface that it stands for: they sum up to the element's.
};

class Mesh {
public:
    /// A root element for each face. `order`: Basis.
    Mesh(const Scene &, int order);

    const Scene &scene() const { return scene_; }
    int order() const { return order_; }
    std::span<const PlacedDomain> domains() const { return domains_; }
    std::span<const Face> faces() const { return faces_; }
    int size() const { return int(elements_.size()); }
    const Element &element(int e) const { return elements_[std::size_t(e)]; }
    const Face &faceOf(int e) const { return faces_[elements_[std::size_t(e)].face]; }
    const PlacedDomain &domainOf(int e) const { return domains_[faceOf(e).domain]; }
    const Basis &basis(int e) const { return Basis::of(domainOf(e).domain.triangles, order_); }
    /// Of an element's nodes, and whatever else is kept a node.
    int stride() const { return stride_; }
    std::span<const Node> nodes(int e) const {
        return {nodes_.data() + std::size_t(e) * std::size_t(stride_),
                std::size_t(basis(e).nodes())};
    }
    const Sides &sides(int e) const { return sides_[std::size_t(element(e).sides)]; }
    double area() const { return area_; } ///< Of all faces with elements.

    /// Gives those elements, leaves, their children; in this order.
    void subdivide(std::span<const int> elements);
    /// The faces that points of a shape lie on; the first piece's front.
    std::int32_t firstFace(std::uint32_t instance, std::uint32_t shape) const;
    std::int32_t faceAt(std::uint32_t instance, std::uint32_t shape, std::uint32_t piece,
                        bool isBack) const;
    /// The leaf at a place of the face, which becomes the leaf's own.
    int leafAt(std::int32_t face, Place &) const;
    /// A place of the element in its face.
    static Place inFace(const Element &e, Place own) {
        return {e.origin.u + e.scale * own.u, e.origin.v + e.scale * own.v};
    }
    /// A place of the face in the element.
    static Place inElement(const Element &e, Place inFace) {
        return {(inFace.u - e.origin.u) / e.scale, (inFace.v - e.origin.v) / e.scale};
    }

private:
    void makeFaces();
    void leaveOutSkies();
    void measure(int first);
    void findCuts(int first);
    void findSides(std::span<const int> parents);

    const Scene &scene_;
    int order_, stride_;
    std::vector<PlacedDomain> domains_;
    std::vector<std::int32_t> firstFace_;    ///< By domain.
    std::vector<std::uint32_t> firstDomain_; ///< Of instances.
    std::vector<Face> faces_;
    std::vector<Element> elements_;
    std::vector<Node> nodes_;
    std::vector<Sides> sides_;
    double area_ = 0;
};

} // namespace candela::radiosity
