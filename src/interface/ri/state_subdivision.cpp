// SPDX-License-Identifier: Apache-2.0
// Subdivision meshes (RI 3.2, section 5.3) and their tags.
#include "interface/ri/state_handlers.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace candela {

namespace {

/// What a tag is given.
struct Tag {
    const std::string &name;
    std::span<const int> integers;
    std::span<const float> floats;
};

/// The floats of a tag for so many things: one each, or one for all.
std::optional<std::vector<float>> sharpnesses(const Tag &tag, std::size_t things) {
    const auto isSharpness = [](float x) { return x >= 0; };
    if (tag.floats.empty() || (tag.floats.size() != 1 && tag.floats.size() != things) ||
        !std::ranges::all_of(tag.floats, isSharpness))
        return std::nullopt;
    std::vector<float> result(things, tag.floats[0]);
    if (tag.floats.size() > 1)
        result.assign(tag.floats.begin(), tag.floats.end());
    return result;
}

bool areBelow(std::span<const int> indices, int end) {
    return std::ranges::all_of(indices, [&](int i) { return i >= 0 && i < end; });
}

/// Reads tags into a mesh whose faces are known.
class TagReader {
public:
    TagReader(SubdivisionRecord &mesh, int vertices) : mesh_(mesh), vertices_(vertices) {}

    static bool knows(const std::string &name) {
        return name == "hole" || name == "crease" || name == "corner" ||
               name == "interpolateboundary" || name == "facevaryinginterpolateboundary";
    }
    /// Of finer levels of a hierarchical mesh.
    static bool isEdit(const std::string &name) {
        return name == "vertexedit" || name == "edgeedit" || name == "faceedit";
    }
    /// What is wrong with a known tag, which then has no effect; empty if nothing is.
    std::string read(const Tag &tag) {
        if (tag.name == "hole")
            return hole(tag);
        if (tag.name == "crease")
            return crease(tag);
        if (tag.name == "corner")
            return corner(tag);
        if (tag.name == "interpolateboundary")
            return number(tag, 1, 2, mesh_.interpolateBoundary);
        return number(tag, 1, 3, mesh_.faceVaryingBoundary);
    }

private:
    std::string hole(const Tag &tag) {
        if (!areBelow(tag.integers, int(mesh_.vertexCounts.size())))
            return "has no good arguments: expected numbers of faces, counted from 0";
        mesh_.holes.insert(mesh_.holes.end(), tag.integers.begin(), tag.integers.end());
        return {};
    }

    std::string crease(const Tag &tag) {
        if (tag.integers.size() < 2 || !areBelow(tag.integers, vertices_))
            return "has no good arguments: expected at least two vertices, counted from 0";
        const std::size_t edges = tag.integers.size() - 1;
        const auto sharpness = sharpnesses(tag, edges);
        if (!sharpness)
            return "has no good arguments: expected a sharpness of 0 or more, for all edges or for "
                   "each";
        for (std::size_t i = 0; i < edges; ++i)
            mesh_.creases.push_back({{tag.integers[i], tag.integers[i + 1]}, (*sharpness)[i]});
        return {};
    }

    std::string corner(const Tag &tag) {
        if (!areBelow(tag.integers, vertices_))
            return "has no good arguments: expected vertices, counted from 0";
        const auto sharpness = sharpnesses(tag, tag.integers.size());
        if (!sharpness)
            return "has no good arguments: expected a sharpness of 0 or more, for all vertices or "
                   "for each";
        for (std::size_t i = 0; i < tag.integers.size(); ++i)
            mesh_.corners.push_back({tag.integers[i], (*sharpness)[i]});
        return {};
    }

    static std::string number(const Tag &tag, int without, int most, int &value) {
        const int given = tag.integers.empty() ? without : tag.integers[0];
        if (given < 0 || given > most)
            return "has no good arguments: expected a number from 0 to " + std::to_string(most);
        value = given;
        return {};
    }

    SubdivisionRecord &mesh_;
    int vertices_;
};

std::optional<SubdivisionRecord::Scheme> schemeOf(const std::string &name) {
    using Scheme = SubdivisionRecord::Scheme;
    if (name == "catmull-clark")
        return Scheme::CatmullClark;
    if (name == "bilinear")
        return Scheme::Bilinear;
    if (name == "loop")
        return Scheme::Loop;
    return std::nullopt;
}

} // namespace

/// Tags count integers and floats, as RI has it, or integers, floats and strings.
void StateHandlers::readTags(const SourceLocation &where, const SubdivisionTags &tags,
                             SubdivisionRecord &mesh) {
    const std::size_t names = tags.names.size();
    const auto complain = [&](const std::string &what) {
        diagnostics_.error(where, "SubdivisionMesh", what);
    };
    const std::size_t counts = names == 0 ? 0 : tags.argumentCounts.size() / names;
    if (names != 0 && (counts * names != tags.argumentCounts.size() || counts < 2 || counts > 3))
        return complain("expected two counts of arguments for each tag; all tags are left out");
    const int last = mesh.vertices.empty() ? -1 : *std::ranges::max_element(mesh.vertices);
    TagReader reader(mesh, last + 1);
    std::size_t integer = 0, number = 0;
    for (std::size_t i = 0; i < names; ++i) {
        const int integers = tags.argumentCounts[counts * i];
        const int floats = tags.argumentCounts[counts * i + 1];
        if (integers < 0 || floats < 0 || integer + std::size_t(integers) > tags.integers.size() ||
            number + std::size_t(floats) > tags.floats.size())
            return complain("the tag \"" + tags.names[i] +
                            "\" counts more arguments than there are; it and those after it are "
                            "left out");
        const Tag tag{tags.names[i],
                      {tags.integers.data() + integer, std::size_t(integers)},
                      {tags.floats.data() + number, std::size_t(floats)}};
        integer += std::size_t(integers), number += std::size_t(floats);
        if (TagReader::isEdit(tag.name))
            diagnostics_.warnOnce(where, "hierarchical edits",
                                  "HierarchicalSubdivisionMesh: edits of finer levels (vertexedit, "
                                  "edgeedit, faceedit) have no effect: the mesh is drawn as it is "
                                  "without them");
        else if (!TagReader::knows(tag.name))
            diagnostics_.warnOnce(where, "tag " + tag.name,
                                  "SubdivisionMesh: the tag \"" + tag.name +
                                      "\" is not known here and has no effect");
        else if (const std::string defect = reader.read(tag); !defect.empty())
            complain("the tag \"" + tag.name + "\" " + defect + "; it is left out");
    }
}

void StateHandlers::subdivisionMesh(const SourceLocation &where, const std::string &scheme,
                                    const Integers &vertexCounts, const Integers &vertices,
                                    const SubdivisionTags &tags, const TokenList &tokens) {
    const auto known = schemeOf(scheme);
    if (!known)
        diagnostics_.warning(where, "SubdivisionMesh",
                             "the scheme \"" + scheme +
                                 "\" is not known here: it is drawn as \"catmull-clark\"");
    SubdivisionRecord mesh;
    mesh.scheme = known.value_or(SubdivisionRecord::Scheme::CatmullClark);
    mesh.vertexCounts = vertexCounts;
    mesh.vertices = vertices;
    readTags(where, tags, mesh);
    emit(where, "SubdivisionMesh", std::move(mesh), tokens);
}

/// Its hierarchy is left out.
void StateHandlers::hierarchicalSubdivisionMesh(
    const SourceLocation &where, const std::string &scheme, const Integers &vertexCounts,
    const Integers &vertices, const Strings &tags, const Integers &argumentCounts,
    const Integers &integers, const Floats &floats, const Strings &, const TokenList &tokens) {
    subdivisionMesh(where, scheme, vertexCounts, vertices, {tags, argumentCounts, integers, floats},
                    tokens);
}

} // namespace candela
