// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/bad_faces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>

namespace candela {

namespace {

/// Where a polygon's loops and corners stand among those of all.
struct Face {
    std::size_t firstLoop, loops, firstCorner, corners;
};

/// Nothing if the counts do not fit each other.
std::vector<Face> facesOf(const PolygonsRecord &polygons) {
    const auto sum = [](const std::vector<int> &counts) {
        return std::accumulate(counts.begin(), counts.end(), std::int64_t(0));
    };
    const auto isNegative = [](int count) { return count < 0; };
    if (std::ranges::any_of(polygons.loopCounts, [](int count) { return count < 1; }) ||
        std::ranges::any_of(polygons.vertexCounts, isNegative) ||
        sum(polygons.loopCounts) != std::int64_t(polygons.vertexCounts.size()) ||
        sum(polygons.vertexCounts) != std::int64_t(polygons.vertices.size()))
        return {};
    std::vector<Face> faces;
    std::size_t loop = 0, corner = 0;
    for (const int loops : polygons.loopCounts) {
        Face face{loop, std::size_t(loops), corner, 0};
        for (; loop < face.firstLoop + face.loops; ++loop)
            face.corners += std::size_t(polygons.vertexCounts[loop]);
        corner += face.corners;
        faces.push_back(face);
    }
    return faces;
}

class FaceJudge {
public:
    FaceJudge(const PolygonsRecord &polygons, const std::vector<float> &points)
        : polygons_(polygons), points_(points) {}

    /// What is wrong with the face; empty if nothing is.
    std::string defectOf(const Face &face) const {
        for (std::size_t loop = face.firstLoop; loop < face.firstLoop + face.loops; ++loop)
            if (polygons_.vertexCounts[loop] < 3)
                return "has fewer than three vertices in a loop";
        for (const int vertex :
             std::span(polygons_.vertices).subspan(face.firstCorner, face.corners)) {
            if (vertex < 0)
                return "has the negative vertex " + std::to_string(vertex);
            if (std::size_t(vertex) >= points_.size() / 3)
                return "has the vertex " + std::to_string(vertex) + ", but there are " +
                       std::to_string(points_.size() / 3) + " points, counted from 0";
            for (const float coordinate : std::span(points_).subspan(3 * std::size_t(vertex), 3))
                if (!std::isfinite(coordinate))
                    return "has the vertex " + std::to_string(vertex) + ", which is not finite";
        }
        return {};
    }

private:
    const PolygonsRecord &polygons_;
    const std::vector<float> &points_;
};

template <class Value>
void appendRange(std::vector<Value> &to, const std::vector<Value> &from, std::size_t first,
                 std::size_t count) {
    to.insert(to.end(), from.begin() + std::ptrdiff_t(first),
              from.begin() + std::ptrdiff_t(first + count));
}

PolygonsRecord onlyThese(const PolygonsRecord &all, const std::vector<Face> &faces) {
    PolygonsRecord kept;
    for (const Face &face : faces) {
        kept.loopCounts.push_back(int(face.loops));
        appendRange(kept.vertexCounts, all.vertexCounts, face.firstLoop, face.loops);
        appendRange(kept.vertices, all.vertices, face.firstCorner, face.corners);
    }
    return kept;
}

/// The values of those faces, or of their corners.
template <class Value>
std::vector<Value> onlyOfThese(const std::vector<Value> &all, const std::vector<Face> &faces,
                               bool areOfFaces, std::size_t components,
                               const std::vector<std::size_t> &numbers) {
    std::vector<Value> kept;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::size_t first = areOfFaces ? numbers[i] : faces[i].firstCorner;
        const std::size_t count = areOfFaces ? 1 : faces[i].corners;
        appendRange(kept, all, first * components, count * components);
    }
    return kept;
}

/// Variables whose values do not fit the faces as they were are left for others to judge.
void keepValues(Parameter &variable, const std::vector<Face> &faces,
                const std::vector<std::size_t> &numbers, std::size_t allFaces,
                std::size_t allCorners) {
    const StorageClass storage = variable.declaration.storage;
    const bool areOfFaces = storage == StorageClass::Uniform;
    if (!areOfFaces && storage != StorageClass::FaceVarying && storage != StorageClass::FaceVertex)
        return;
    const auto components = std::size_t(std::max(1, variable.declaration.components()));
    if (variable.floats.size() + variable.strings.size() !=
        components * (areOfFaces ? allFaces : allCorners))
        return;
    if (variable.strings.empty())
        variable.floats = onlyOfThese(variable.floats, faces, areOfFaces, components, numbers);
    else
        variable.strings = onlyOfThese(variable.strings, faces, areOfFaces, components, numbers);
}

/// Whether it is worth while to look at each face.
bool mayHaveBadFaces(const PolygonsRecord &polygons, const std::vector<float> &points) {
    const auto isBadIndex = [&](int vertex) {
        return vertex < 0 || std::size_t(vertex) >= points.size() / 3;
    };
    return std::ranges::any_of(polygons.vertexCounts, [](int count) { return count < 3; }) ||
           std::ranges::any_of(polygons.vertices, isBadIndex) ||
           !std::ranges::all_of(points, [](float value) { return std::isfinite(value); });
}

} // namespace

std::string leaveOutBadFaces(PolygonsRecord &polygons, ParameterList &variables) {
    const auto position = std::ranges::find(variables.all, "P", &Parameter::name);
    if (position == variables.all.end() || position->floats.size() % 3 != 0 ||
        !mayHaveBadFaces(polygons, position->floats))
        return {};
    const std::vector<Face> faces = facesOf(polygons);
    const FaceJudge judge(polygons, position->floats);
    std::vector<Face> good;
    std::vector<std::size_t> numbers; ///< Of the good ones.
    std::string first;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const std::string defect = judge.defectOf(faces[i]);
        if (defect.empty()) {
            good.push_back(faces[i]);
            numbers.push_back(i);
        } else if (first.empty()) {
            first = "face " + std::to_string(i) + " " + defect;
        }
    }
    if (good.empty())
        return {};
    for (Parameter &variable : variables.all)
        keepValues(variable, good, numbers, faces.size(), polygons.vertices.size());
    for (float &coordinate : position->floats)
        if (!std::isfinite(coordinate))
            coordinate = 0;
    if (first.empty()) // No face uses those points.
        return {};
    polygons = onlyThese(polygons, good);
    const std::size_t more = faces.size() - good.size() - 1;
    return first +
           (more == 0 ? "; it is left out"
                      : ", and " + std::to_string(more) + " others are as bad: these are left out");
}

} // namespace candela
