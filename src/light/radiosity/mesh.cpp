// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/mesh.h"

#include "foundation/base/parallel.h"
#include "light/radiosity/cuts.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace candela::radiosity {

namespace {

/// Places on faces, to be measured together.
struct PlaceList {
    std::vector<std::uint32_t> instance, shape, piece;
    std::vector<float> u, v, planes;

    void add(const PlacedDomain &domain, const Face &face, Place at) {
        instance.push_back(domain.instance), shape.push_back(domain.shape);
        piece.push_back(face.piece);
        u.push_back(at.u), v.push_back(at.v);
    }
    int size() const { return int(u.size()); }
    float *plane(int k) { return planes.data() + std::size_t(k) * u.size(); }
    Vec3Planes P() { return {plane(0), plane(1), plane(2)}; }
    Vec3Planes Ng() { return {plane(3), plane(4), plane(5)}; }
    void measure(const Scene &scene) {
        planes.resize(7 * u.size());
        scene.domains().frames(
            {size(), instance.data(), shape.data(), piece.data(), u.data(), v.data()}, P(), Ng(),
            plane(6));
    }
};

/// Lamps of so many times the area of all else are skies.
constexpr double sky = 8;

/// Twice the vector area of a closed line.
Vec3 vectorArea(std::span<const Vec3> corners) {
    Vec3 sum;
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        sum += cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
    return sum;
}

/// No node sees another above its own horizon.
bool seesNothingOfItself(std::span<const Node> nodes, std::span<const Vec3> corners, float size) {
    for (const Node &node : nodes)
        for (Vec3 corner : corners)
            if (dot(node.N, corner - node.P) > 1e-4f * size)
                return false;
    return true;
}

bool isPlane(std::span<const Node> nodes, Vec3 normal) {
    constexpr float same = 0.9999f; // Cosine.
    return std::ranges::all_of(nodes, [&](const Node &node) { return dot(node.N, normal) > same; });
}

/// On either side of it.
bool liesInPlaneOf(const Element &plane, const Element &element) {
    const Vec3 way = element.centre - plane.centre;
    return plane.isPlane && element.isPlane &&
           length(cross(element.normal, plane.normal)) < 1e-3f &&
           std::fabs(dot(way, plane.normal)) < 1e-3f * (plane.radius + length(way));
}

} // namespace

Mesh::Mesh(const Scene &scene, int order)
    : scene_(scene), order_(order), stride_(order <= 2 ? 4 : mostNodes),
      domains_(scene.domains().all()) {
    makeFaces();
}

void Mesh::makeFaces() {
    for (std::uint32_t d = 0; d < domains_.size(); ++d) {
        const PlacedDomain &domain = domains_[d];
        while (domain.instance != noHit && firstDomain_.size() <= domain.instance)
            firstDomain_.push_back(d);
        firstFace_.push_back(std::int32_t(faces_.size()));
        for (std::uint32_t piece = 0; piece < domain.domain.pieces; ++piece) {
            const std::int32_t front = std::int32_t(faces_.size());
            faces_.push_back({d, piece, false, domain.isOneSided ? -1 : front + 1, -1});
            if (!domain.isOneSided)
                faces_.push_back({d, piece, true, front, -1});
        }
    }
    for (std::uint32_t f = 0; f < faces_.size(); ++f) {
        Element root;
        root.face = f;
        elements_.push_back(root);
    }
    measure(0);
    // Faces without area keep no element, and the others move up.
    std::vector<Element> kept;
    std::vector<Node> nodes;
    for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (!(elements_[e].area > 0) || !std::isfinite(elements_[e].area))
            continue;
        faces_[elements_[e].face].root = std::int32_t(kept.size());
        kept.push_back(elements_[e]);
        nodes.insert(nodes.end(), nodes_.begin() + std::ptrdiff_t(e) * stride_,
                     nodes_.begin() + std::ptrdiff_t(e + 1) * stride_);
        area_ += elements_[e].area;
    }
    elements_ = std::move(kept), nodes_ = std::move(nodes);
    leaveOutSkies();
    findCuts(0);
}

/// Lamps that are much larger than all else, and around it: elements of them would be all there is.
/// They are sampled as other light sources are, and what falls on them is nobody's concern.
void Mesh::leaveOutSkies() {
    struct Lamp {
        double area = 0;
        int root = -1;
        bool isPlane = true; ///< What lies in one plane surrounds nothing.
    };
    std::map<int, Lamp> lamps; // By light.
    for (const Face &face : faces_)
        if (const int light = domains_[face.domain].light; light > 0 && face.root >= 0) {
            Lamp &lamp = lamps[light];
            if (lamp.root < 0)
                lamp.root = face.root;
            lamp.area += element(face.root).area;
            lamp.isPlane &= liesInPlaneOf(element(lamp.root), element(face.root));
        }
    for (const auto &[light, lamp] : lamps) {
        const double area = lamp.area, others = area_ - area;
        if (!(others > 0) || area < sky * others || lamp.isPlane)
            continue;
        for (Face &face : faces_)
            if (domains_[face.domain].light == light)
                face.root = -1;
        area_ = others;
    }
}

void Mesh::subdivide(std::span<const int> elements) {
    const int first = size();
    for (int e : elements) {
        elements_[std::size_t(e)].firstChild = size();
        const Element parent = element(e);
        const bool triangle = domainOf(e).domain.triangles;
        for (int c = 0; c < Basis::children; ++c) {
            const Basis::ChildPlace place = Basis::child(triangle, c);
            Element child;
            child.face = parent.face, child.parent = e, child.level = parent.level + 1;
            child.origin = inFace(parent, place.origin);
            child.scale = parent.scale * place.scale;
            elements_.push_back(child);
        }
    }
    measure(first);
    findCuts(first);
    findSides(elements);
}

void Mesh::findSides(std::span<const int> parents) {
    std::vector<int> cut;
    std::ranges::copy_if(parents, std::back_inserter(cut), [&](int e) { return element(e).isCut; });
    const std::vector<Sides> found = sidesOf(*this, cut);
    for (std::size_t k = 0; k < cut.size(); ++k) {
        Element &parent = elements_[std::size_t(cut[k])];
        parent.sides = std::int32_t(sides_.size());
        sides_.push_back(found[k]);
        const int nodes = basis(cut[k]).nodes();
        for (int c = 0; c < Basis::children; ++c)
            for (int i = 0; i < nodes; ++i)
                parent.isTorn |= found[k][std::size_t(c * mostNodes + i)] < 0;
    }
}

void Mesh::findCuts(int first) {
    const std::vector<std::uint8_t> cut = cutElements(*this, first);
    for (std::size_t k = 0; k < cut.size(); ++k)
        elements_[std::size_t(first) + k].isCut = cut[k] != 0;
}

/// What elements from `first` on know of the surface.
void Mesh::measure(int first) {
    nodes_.resize(elements_.size() * std::size_t(stride_));
    constexpr int batch = 256;
    const int batches = (size() - first + batch - 1) / batch;
    parallelFor(std::size_t(batches), [&](std::size_t b) {
        const int begin = first + int(b) * batch, end = std::min(begin + batch, size());
        PlaceList places;
        for (int e = begin; e < end; ++e) {
            const Basis &basis = this->basis(e);
            const Element &own = element(e);
            const auto add = [&](Place at) { places.add(domainOf(e), faceOf(e), inFace(own, at)); };
            for (int i = 0; i < basis.nodes(); ++i)
                add(basis.node(i));
            for (Place corner : Basis::corners(basis.isTriangle()))
                add(corner);
            add(Basis::centre(basis.isTriangle()));
        }
        places.measure(scene_);
        int at = 0;
        for (int e = begin; e < end; ++e) {
            const Basis &basis = this->basis(e);
            Element &own = elements_[std::size_t(e)];
            const float side = faceOf(e).isBack ? -1.0f : 1.0f;
            Node *node = nodes_.data() + std::size_t(e) * std::size_t(stride_);
            own.area = 0;
            for (int i = 0; i < basis.nodes(); ++i, ++at) {
                node[i] = {places.P().get(at), places.Ng().get(at) * side,
                           basis.weight(i) * own.scale * own.scale * places.plane(6)[at]};
                own.area += node[i].area;
            }
            const std::size_t corners = Basis::corners(basis.isTriangle()).size();
            for (std::size_t k = 0; k < corners; ++k, ++at)
                own.corners[k] = places.P().get(at);
            own.centre = places.P().get(at), own.normal = places.Ng().get(at) * side;
            ++at;
            const std::span<const Vec3> line(own.corners.data(), corners);
            const Vec3 chords = vectorArea(line);
            own.turned = dot(chords, own.normal) < 0 ? -1.0f : 1.0f;
            Vec3 all;
            for (int i = 0; i < basis.nodes(); ++i)
                all += node[i].N * node[i].area;
            own.fullness = 2 * length(all) / std::max(length(chords), 1e-30f);
            own.radius = 0;
            for (Vec3 corner : line)
                own.radius = std::max(own.radius, length(corner - own.centre));
            for (int i = 0; i < basis.nodes(); ++i)
                own.radius = std::max(own.radius, length(node[i].P - own.centre));
            own.isPlane = isPlane({node, std::size_t(basis.nodes())}, own.normal);
            own.isFlat = seesNothingOfItself({node, std::size_t(basis.nodes())}, line, own.radius);
        }
    });
}

std::int32_t Mesh::firstFace(std::uint32_t instance, std::uint32_t shape) const {
    std::size_t domain = shape;
    if (instance != noHit) {
        domain = firstDomain_[instance];
        domain += shape - domains_[domain].shape;
    }
    return firstFace_[domain];
}

std::int32_t Mesh::faceAt(std::uint32_t instance, std::uint32_t shape, std::uint32_t piece,
                          bool isBack) const {
    const std::int32_t first = firstFace(instance, shape);
    const PlacedDomain &domain = domains_[faces_[std::size_t(first)].domain];
    if (domain.isOneSided)
        return isBack ? -1 : first + std::int32_t(piece);
    return first + 2 * std::int32_t(piece) + (isBack ? 1 : 0);
}

int Mesh::leafAt(std::int32_t face, Place &at) const {
    int e = face >= 0 ? faces_[std::size_t(face)].root : -1;
    while (e >= 0 && element(e).firstChild >= 0)
        e = element(e).firstChild + Basis::childAt(domainOf(e).domain.triangles, at);
    return e;
}

} // namespace candela::radiosity
