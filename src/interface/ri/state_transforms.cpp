// SPDX-License-Identifier: Apache-2.0
// Transformations and coordinate systems (RI 3.2, section 4.3).
#include "interface/ri/state_handlers.h"

#include <cmath>

namespace candela {

/// The matrix without what rounding has left in its last column; nothing if it is projective.
static std::optional<Matrix4d> affine(const Matrix4d &matrix) {
    const double w = matrix.at(3, 3);
    Matrix4d result;
    for (int row = 0; row < 4; ++row) {
        if (row < 3 && !(std::fabs(matrix.at(row, 3)) <= 1e-6 * std::fabs(w)))
            return std::nullopt;
        for (int column = 0; column < 3; ++column)
            result.at(row, column) = matrix.at(row, column) / w;
    }
    return result;
}

/// Also where the world, which gets floats, could not hold it.
static bool isFiniteAsFloats(const Matrix4d &matrix) {
    return isFinite(inDouble(matrix.rounded()));
}

/// Space loses a dimension, or so nearly that the rounding of coordinates is all that is left of
/// it: a volume of 1e-12 of what the stretches of the three coordinates would give at right angles.
static bool flattens(const Matrix4d &matrix) {
    const auto at = [&](int row, int column) { return matrix.at(row, column); };
    double volume = 0, box = 1;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        volume += at(0, i) * (at(1, j) * at(2, k) - at(1, k) * at(2, j));
        box *= std::hypot(at(0, i), at(1, i), at(2, i));
    }
    return !(std::fabs(volume) > 1e-12 * box) || !inverse(matrix.rounded());
}

void StateHandlers::setTransform(const SourceLocation &where, const char *request,
                                 const Matrix4d &matrix) {
    std::optional<Matrix4d> kept = affine(matrix);
    if (!kept && inverse(matrix))
        warnOnce(where, "projective",
                 std::string(request) + ": this version has no perspective but that of Projection; "
                                        "requests that make things taper are left out");
    else if (kept && isFiniteAsFloats(*kept))
        ctm_ = {*kept, flattens(*kept)};
    else
        error(where, request,
              "the transformation would not be finite, or a projection onto a plane; the request "
              "is left out");
}

void StateHandlers::concatenate(const SourceLocation &where, const char *request,
                                const Matrix4d &matrix) {
    setTransform(where, request, matrix * ctm_.matrix);
}

bool StateHandlers::isFlat(const SourceLocation &where, const char *request, const char *what) {
    if (ctm_.flat)
        diagnostics_.warning(where, std::string(request) +
                                        ": the transformation is singular (it flattens space); " +
                                        what + " is left out");
    return ctm_.flat;
}

void StateHandlers::identity(const SourceLocation &) { ctm_ = base_; }

void StateHandlers::transform(const SourceLocation &where, const Matrix4 &matrix) {
    setTransform(where, "Transform", inDouble(matrix) * base_.matrix);
}

void StateHandlers::concatTransform(const SourceLocation &where, const Matrix4 &matrix) {
    concatenate(where, "ConcatTransform", inDouble(matrix));
}

void StateHandlers::perspective(const SourceLocation &where, float fieldOfView) {
    if (!(fieldOfView > 0 && fieldOfView < 180))
        return error(where, "Perspective", "expected an angle between 0 and 180 degrees");
    concatenate(where, "Perspective", perspectiveInDouble(fieldOfView));
}

void StateHandlers::translate(const SourceLocation &where, float dx, float dy, float dz) {
    concatenate(where, "Translate", translationInDouble(dx, dy, dz));
}

void StateHandlers::rotate(const SourceLocation &where, float angle, float dx, float dy, float dz) {
    if (!finite(where, "Rotate", {angle, dx, dy, dz}))
        return;
    if (length({dx, dy, dz}) == 0)
        return error(where, "Rotate", "the axis has no length; the request is left out");
    concatenate(where, "Rotate", rotationInDouble(angle, {dx, dy, dz}));
}

void StateHandlers::scale(const SourceLocation &where, float sx, float sy, float sz) {
    concatenate(where, "Scale", scalingInDouble(sx, sy, sz));
}

void StateHandlers::skew(const SourceLocation &where, float angle, float dx1, float dy1, float dz1,
                         float dx2, float dy2, float dz2) {
    if (!finite(where, "Skew", {angle, dx1, dy1, dz1, dx2, dy2, dz2}))
        return;
    Vec3 turned = normalize({dx1, dy1, dz1}), towards = normalize({dx2, dy2, dz2});
    if (length(cross(turned, towards)) < 1e-6f)
        return error(where, "Skew", "expected two axes that are not parallel");
    float between = std::acos(dot(turned, towards)) * 180 / float(M_PI);
    if (angle >= between || angle <= between - 180)
        return error(where, "Skew",
                     "expected an angle below the one between the axes and above "
                     "that minus 180 degrees");
    concatenate(where, "Skew", skewInDouble(angle, turned, towards));
}

void StateHandlers::coordinateSystem(const SourceLocation &, const std::string &name) {
    const Matrix4 currentFromSpace = ctm_.matrix.rounded();
    coordinateSystems_[name] = ctm_;
    options_.coordinateSystems[name] = currentFromSpace;
    if (inWorld_)
        builder_.coordinateSystem(name, currentFromSpace);
}

void StateHandlers::coordSysTransform(const SourceLocation &where, const std::string &name) {
    auto found = coordinateSystems_.find(name);
    if (found != coordinateSystems_.end())
        ctm_ = found->second;
    else
        error(where, "CoordSysTransform", "no coordinate system '" + name + "' has been named");
}

} // namespace candela
