// SPDX-License-Identifier: Apache-2.0
// Transformations and coordinate systems (RI 3.2, section 4.3).
#include "interface/ri/state_handlers.h"

#include <cmath>

namespace candela {

using Kind = TransformSample::Kind;

void StateHandlers::report(const SourceLocation &where, const char *request,
                           TransformDefect defect) {
    if (defect == TransformDefect::Projective)
        diagnostics_.warnOnce(where, "projective",
                              std::string(request) +
                                  ": this version has no perspective but that of Projection; "
                                  "requests that make things taper are left out");
    else if (defect == TransformDefect::NotFinite)
        diagnostics_.error(where, request,
                           "the transformation would not be finite, or a projection onto a plane; "
                           "the request is left out");
}

void StateHandlers::concatenate(const SourceLocation &where, const char *request,
                                const TransformSample &sample) {
    if (motion_)
        return motion_->samples.push_back(sample);
    report(where, request, candela::concatenate(state_.transform.current, sample.factor()));
}

void StateHandlers::replace(const SourceLocation &where, const char *request,
                            const TransformSample &sample) {
    if (motion_) {
        motion_->fromBase = true;
        return motion_->samples.push_back(sample);
    }
    report(where, request,
           assign(state_.transform.current, sample.factor() * state_.transform.base.matrix));
}

bool StateHandlers::isFlat(const SourceLocation &where, const char *request, const char *what) {
    const bool flat = state_.transform.current.flat;
    if (flat)
        diagnostics_.warning(where, request,
                             std::string("the transformation is singular (it flattens space); ") +
                                 what + " is left out");
    return flat;
}

void StateHandlers::identity(const SourceLocation &where) { replace(where, "Identity", {}); }

void StateHandlers::transform(const SourceLocation &where, const Matrix4 &matrix) {
    replace(where, "Transform", {Kind::Matrix, inDouble(matrix), 0, {}, {}});
}

void StateHandlers::concatTransform(const SourceLocation &where, const Matrix4 &matrix) {
    concatenate(where, "ConcatTransform", {Kind::Matrix, inDouble(matrix), 0, {}, {}});
}

void StateHandlers::perspective(const SourceLocation &where, float fieldOfView) {
    if (!(fieldOfView > 0 && fieldOfView < 180))
        return diagnostics_.error(where, "Perspective",
                                  "expected an angle between 0 and 180 degrees");
    concatenate(where, "Perspective", {Kind::Matrix, perspectiveInDouble(fieldOfView), 0, {}, {}});
}

void StateHandlers::translate(const SourceLocation &where, float dx, float dy, float dz) {
    concatenate(where, "Translate", {Kind::Translation, {}, 0, {dx, dy, dz}, {}});
}

void StateHandlers::rotate(const SourceLocation &where, float angle, float dx, float dy, float dz) {
    if (!diagnostics_.finite(where, "Rotate", {angle, dx, dy, dz}))
        return;
    if (length({dx, dy, dz}) == 0)
        return diagnostics_.error(where, "Rotate",
                                  "the axis has no length; the request is left out");
    concatenate(where, "Rotate", {Kind::Rotation, {}, angle, {dx, dy, dz}, {}});
}

void StateHandlers::scale(const SourceLocation &where, float sx, float sy, float sz) {
    concatenate(where, "Scale", {Kind::Scaling, {}, 0, {sx, sy, sz}, {}});
}

void StateHandlers::skew(const SourceLocation &where, float angle, float dx1, float dy1, float dz1,
                         float dx2, float dy2, float dz2) {
    if (!diagnostics_.finite(where, "Skew", {angle, dx1, dy1, dz1, dx2, dy2, dz2}))
        return;
    Vec3 turned = normalize({dx1, dy1, dz1}), towards = normalize({dx2, dy2, dz2});
    if (length(cross(turned, towards)) < 1e-6f)
        return diagnostics_.error(where, "Skew", "expected two axes that are not parallel");
    float between = std::acos(dot(turned, towards)) * 180 / float(M_PI);
    if (angle >= between || angle <= between - 180)
        return diagnostics_.error(where, "Skew",
                                  "expected an angle below the one between the axes and above "
                                  "that minus 180 degrees");
    concatenate(where, "Skew", {Kind::Skew, {}, angle, turned, towards});
}

void StateHandlers::coordinateSystem(const SourceLocation &, const std::string &name) {
    const Matrix4 currentFromSpace = state_.transform.current.matrix.rounded();
    state_.coordinateSystems[name] = state_.transform.current;
    state_.options.coordinateSystems[name] = currentFromSpace;
    if (state_.inWorld)
        builder_.coordinateSystem(name, currentFromSpace);
}

/// Until the attribute block ends. Shaders know one system of each name in a world, the last one.
void StateHandlers::scopedCoordinateSystem(const SourceLocation &where, const std::string &name) {
    const Matrix4 currentFromSpace = state_.transform.current.matrix.rounded();
    auto scoped =
        state_.scopedSystems
            ? std::make_shared<std::map<std::string, CurrentTransform>>(*state_.scopedSystems)
            : std::make_shared<std::map<std::string, CurrentTransform>>();
    (*scoped)[name] = state_.transform.current;
    state_.scopedSystems = std::move(scoped);
    const auto [known, isNew] =
        state_.options.coordinateSystems.try_emplace(name, currentFromSpace);
    if (!isNew && known->second.m != currentFromSpace.m)
        diagnostics_.warnOnce(where, "scoped system:" + name,
                              "ScopedCoordinateSystem: there are several systems '" + name +
                                  "'; shaders that name it are told of the last one everywhere");
    known->second = currentFromSpace;
    if (state_.inWorld)
        builder_.coordinateSystem(name, currentFromSpace);
}

const CurrentTransform *StateHandlers::coordinateSystemOf(const std::string &name) const {
    if (state_.scopedSystems)
        if (auto found = state_.scopedSystems->find(name); found != state_.scopedSystems->end())
            return &found->second;
    const auto found = state_.coordinateSystems.find(name);
    return found == state_.coordinateSystems.end() ? nullptr : &found->second;
}

void StateHandlers::coordSysTransform(const SourceLocation &where, const std::string &name) {
    if (const CurrentTransform *system = coordinateSystemOf(name))
        state_.transform.current = *system;
    else
        diagnostics_.error(where, "CoordSysTransform",
                           "no coordinate system '" + name + "' has been named");
}

std::optional<Matrix4d> StateHandlers::cameraFrom(const std::string &name) const {
    if (name == "current")
        return state_.transform.current.matrix;
    const CurrentTransform *system = coordinateSystemOf(name);
    return system ? std::optional(system->matrix) : std::nullopt;
}

} // namespace candela
