// SPDX-License-Identifier: Apache-2.0
// Attributes but for shaders and lights (RI 3.2, section 4.2).
#include "interface/ri/state_handlers.h"

#include <algorithm>
#include <cmath>

namespace candela {

Attributes &StateHandlers::edit() {
    if (attributes_.use_count() > 1)
        attributes_ = std::make_shared<Attributes>(*attributes_);
    return *attributes_;
}

static bool allFinite(const Color &color) {
    return std::ranges::all_of(color.c, [](float c) { return std::isfinite(c); });
}

void StateHandlers::color(const SourceLocation &where, const Color &value) {
    if (!allFinite(value))
        return error(where, "Color", "expected finite numbers; the request is left out");
    edit().color = value;
}

void StateHandlers::opacity(const SourceLocation &where, const Color &value) {
    if (!allFinite(value))
        return error(where, "Opacity", "expected finite numbers; the request is left out");
    edit().opacity = value;
    clampOpacity(where, "Opacity", edit().opacity.c);
}

void StateHandlers::clampOpacity(const SourceLocation &where, const char *what,
                                 std::span<float> values) {
    bool beyond = false;
    for (float &value : values) {
        const float within = std::clamp(value, 0.0f, 1.0f);
        beyond |= within != value;
        value = within;
    }
    if (beyond)
        warnOnce(where, std::string("opacity:") + what,
                 std::string(what) + " goes beyond [0,1]; it is taken as 0 or 1 there");
}

void StateHandlers::textureCoordinates(const SourceLocation &where, float s1, float t1, float s2,
                                       float t2, float s3, float t3, float s4, float t4) {
    if (finite(where, "TextureCoordinates", {s1, t1, s2, t2, s3, t3, s4, t4}))
        edit().textureCoordinates = {s1, t1, s2, t2, s3, t3, s4, t4};
}

void StateHandlers::shadingRate(const SourceLocation &where, float size) {
    if (!(size > 0) || !std::isfinite(size))
        return error(where, "ShadingRate", "expected an area above 0, in pixels");
    edit().shadingRate = size;
}

void StateHandlers::shadingInterpolation(const SourceLocation &where, const std::string &type) {
    if (type != "constant" && type != "smooth")
        return error(where, "ShadingInterpolation",
                     "'" + type + "' is unknown: expected \"constant\" or \"smooth\"");
    edit().smoothInterpolation = type == "smooth";
}

void StateHandlers::matte(const SourceLocation &where, bool on) {
    edit().matte = on;
    if (on)
        warnOnce(where, "Matte", "Matte: this version draws matte objects as all others");
}

/// A hint for culling; this renderer bounds its primitives itself.
void StateHandlers::bound(const SourceLocation &where, float xMin, float xMax, float yMin,
                          float yMax, float zMin, float zMax) {
    if (xMin > xMax || yMin > yMax || zMin > zMax)
        error(where, "Bound", "expected minima below maxima; the request is left out");
}

void StateHandlers::geometricApproximation(const SourceLocation &where, const std::string &type,
                                           float value) {
    if (!std::isfinite(value))
        return error(where, "GeometricApproximation", "expected a finite number");
    edit().named["geometricapproximation:" + type] = {type, {}, {value}, {}};
}

void StateHandlers::orientation(const SourceLocation &where, const std::string &name) {
    // RI 3.2, 4.2.9: the orientation turns with the handedness of the coordinate system. Kept
    // relative to that, it stays as it is whatever transformations come later.
    bool rightHanded = flipsHandedness(ctm_.matrix);
    if (name == "outside" || name == "inside")
        edit().flipNormal = name == "inside";
    else if (name == "lh" || name == "rh")
        edit().flipNormal = (name == "rh") != rightHanded;
    else
        error(where, "Orientation",
              "'" + name + "' is unknown: expected \"outside\", \"inside\", \"lh\" or \"rh\"");
}

void StateHandlers::reverseOrientation(const SourceLocation &) {
    bool &flip = edit().flipNormal;
    flip = !flip;
}

void StateHandlers::sides(const SourceLocation &where, int sides) {
    if (sides != 1 && sides != 2)
        return error(where, "Sides", "expected 1 or 2");
    edit().sides = sides;
}

std::optional<BasisRecord> StateHandlers::basisOf(const SourceLocation &where,
                                                  const BasisArgument &basis, int step) {
    static const std::map<std::string, std::array<float, 16>> standard = {
        {"bezier", BasisRecord{}.matrix},
        {"b-spline",
         {-1 / 6.f, 3 / 6.f, -3 / 6.f, 1 / 6.f, 3 / 6.f, -6 / 6.f, 3 / 6.f, 0, -3 / 6.f, 0, 3 / 6.f,
          0, 1 / 6.f, 4 / 6.f, 1 / 6.f, 0}},
        {"catmull-rom",
         {-0.5f, 1.5f, -1.5f, 0.5f, 1, -2.5f, 2, -0.5f, -0.5f, 0, 0.5f, 0, 0, 1, 0, 0}},
        {"hermite", {2, 1, -2, 1, -3, -2, 3, -1, 0, 1, 0, 0, 1, 0, 0, 0}},
        {"power", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
    if (step < 1 || step > 4) {
        error(where, "Basis", "expected a step from 1 to 4; the request is left out");
        return std::nullopt;
    }
    if (const auto *matrix = std::get_if<std::array<float, 16>>(&basis)) {
        if (!std::ranges::all_of(*matrix, [](float m) { return std::isfinite(m); })) {
            error(where, "Basis", "expected finite numbers; the request is left out");
            return std::nullopt;
        }
        return BasisRecord{*matrix, step};
    }
    const std::string &name = std::get<std::string>(basis);
    auto found = standard.find(name);
    if (found == standard.end()) {
        error(where, "Basis",
              "'" + name +
                  "' is unknown: expected \"bezier\", \"b-spline\", "
                  "\"catmull-rom\", \"hermite\", \"power\" or 16 numbers");
        return std::nullopt;
    }
    return BasisRecord{found->second, step};
}

void StateHandlers::basis(const SourceLocation &where, const BasisArgument &u, int uStep,
                          const BasisArgument &v, int vStep) {
    auto uBasis = basisOf(where, u, uStep), vBasis = basisOf(where, v, vStep);
    if (!uBasis || !vBasis)
        return;
    edit().uBasis = *uBasis;
    edit().vBasis = *vBasis;
}

void StateHandlers::attribute(const SourceLocation &, const std::string &category,
                              const TokenList &tokens) {
    for (Parameter &parameter : categorised(tokens, "Attribute", category)) {
        if (category == "identifier" && parameter.name == "name" && !parameter.strings.empty())
            edit().name = parameter.strings.front();
        std::string name = category + ":" + parameter.name;
        edit().named[std::move(name)] = std::move(parameter);
    }
}

} // namespace candela
