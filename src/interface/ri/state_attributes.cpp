// SPDX-License-Identifier: Apache-2.0
// Attributes but for shaders and lights (RI 3.2, section 4.2).
#include "interface/ri/state_handlers.h"
#include "interface/ri/state_parameters.h"
#include "interface/ri/trim_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

static bool allFinite(const Color &color) {
    return std::ranges::all_of(color.c, [](float c) { return std::isfinite(c); });
}

void StateHandlers::color(const SourceLocation &where, const Color &value) {
    if (!allFinite(value))
        return diagnostics_.error(where, "Color",
                                  "expected finite numbers; the request is left out");
    Attributes &attributes = state_.edit(own::Color);
    if (addToMotion(value, attributes.color, attributes.colorMotion))
        return;
    attributes.color = value, attributes.colorMotion = nullptr;
}

void StateHandlers::opacity(const SourceLocation &where, const Color &value) {
    if (!allFinite(value))
        return diagnostics_.error(where, "Opacity",
                                  "expected finite numbers; the request is left out");
    Color within = value;
    diagnostics_.clampOpacity(where, "Opacity", within.c);
    Attributes &attributes = state_.edit(own::Opacity);
    if (addToMotion(within, attributes.opacity, attributes.opacityMotion))
        return;
    attributes.opacity = within, attributes.opacityMotion = nullptr;
}

void StateHandlers::textureCoordinates(const SourceLocation &where, float s1, float t1, float s2,
                                       float t2, float s3, float t3, float s4, float t4) {
    if (diagnostics_.finite(where, "TextureCoordinates", {s1, t1, s2, t2, s3, t3, s4, t4}))
        state_.edit().textureCoordinates = {s1, t1, s2, t2, s3, t3, s4, t4};
}

void StateHandlers::shadingRate(const SourceLocation &where, float size) {
    if (!(size > 0) || !std::isfinite(size))
        return diagnostics_.error(where, "ShadingRate", "expected an area above 0, in pixels");
    state_.edit(own::ShadingRate).shadingRate = size;
}

void StateHandlers::shadingInterpolation(const SourceLocation &where, const std::string &type) {
    if (type != "constant" && type != "smooth")
        return diagnostics_.error(where, "ShadingInterpolation",
                                  "'" + type + "' is unknown: expected \"constant\" or \"smooth\"");
    state_.edit(own::Interpolation).smoothInterpolation = type == "smooth";
}

void StateHandlers::matte(const SourceLocation &, bool on) { state_.edit(own::Matte).matte = on; }

/// A hint for culling; this renderer bounds its primitives itself.
void StateHandlers::bound(const SourceLocation &where, float xMin, float xMax, float yMin,
                          float yMax, float zMin, float zMax) {
    if (xMin > xMax || yMin > yMax || zMin > zMax)
        diagnostics_.error(where, "Bound", "expected minima below maxima; the request is left out");
}

void StateHandlers::geometricApproximation(const SourceLocation &where, const std::string &type,
                                           float value) {
    if (!std::isfinite(value))
        return diagnostics_.error(where, "GeometricApproximation", "expected a finite number");
    state_.edit().named["geometricapproximation:" + type] = {type, {}, {value}, {}};
}

void StateHandlers::orientation(const SourceLocation &where, const std::string &name) {
    // RI 3.2, 4.2.9: the orientation turns with the handedness of the coordinate system. Kept
    // relative to that, it stays as it is whatever transformations come later.
    bool rightHanded = flipsHandedness(state_.transform.current.matrix);
    if (name == "outside" || name == "inside")
        state_.edit().flipNormal = name == "inside";
    else if (name == "lh" || name == "rh")
        state_.edit().flipNormal = (name == "rh") != rightHanded;
    else
        diagnostics_.error(where, "Orientation",
                           "'" + name +
                               "' is unknown: expected \"outside\", \"inside\", \"lh\" or \"rh\"");
}

void StateHandlers::reverseOrientation(const SourceLocation &) {
    bool &flip = state_.edit().flipNormal;
    flip = !flip;
}

void StateHandlers::detail(const SourceLocation &where, float xMin, float xMax, float yMin,
                           float yMax, float zMin, float zMax) {
    if (!(xMin <= xMax && yMin <= yMax && zMin <= zMax))
        return diagnostics_.error(where, "Detail",
                                  "expected minima below maxima; the request is left out");
    state_.edit(own::Detail).detail = std::make_shared<const DetailRecord>(DetailRecord{
        {xMin, xMax, yMin, yMax, zMin, zMax}, state_.transform.current.matrix, object_.isOpen()});
}

void StateHandlers::detailRange(const SourceLocation &where, float minVisible,
                                float lowerTransition, float upperTransition, float maxVisible) {
    if (!(0 <= minVisible && minVisible <= lowerTransition && lowerTransition <= upperTransition &&
          upperTransition <= maxVisible))
        return diagnostics_.error(where, "DetailRange",
                                  "expected four areas from 0 up, none below the one before it; "
                                  "the request is left out");
    // RI_INFINITY.
    const auto known = [](float area) {
        return area < 1e30f ? area : std::numeric_limits<float>::infinity();
    };
    state_.edit(own::DetailRange).detailRange = {minVisible, lowerTransition,
                                                 known(upperTransition), known(maxVisible)};
}

/// RI 3.1; points and lines were meant for previews.
void StateHandlers::geometricRepresentation(const SourceLocation &where, const std::string &type) {
    if (type != "primitive")
        diagnostics_.warnOnce(where, "GeometricRepresentation:" + type,
                              "GeometricRepresentation \"" + type +
                                  "\": surfaces are drawn all the same");
}

void StateHandlers::sides(const SourceLocation &where, int sides) {
    if (sides != 1 && sides != 2)
        return diagnostics_.error(where, "Sides", "expected 1 or 2");
    state_.edit(own::Sides).sides = sides;
}

static std::optional<BasisRecord> basisOf(RequestDiagnostics &diagnostics,
                                          const SourceLocation &where, const BasisArgument &basis,
                                          int step) {
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
        diagnostics.error(where, "Basis", "expected a step from 1 to 4; the request is left out");
        return std::nullopt;
    }
    if (const auto *matrix = std::get_if<std::array<float, 16>>(&basis)) {
        if (!std::ranges::all_of(*matrix, [](float m) { return std::isfinite(m); })) {
            diagnostics.error(where, "Basis", "expected finite numbers; the request is left out");
            return std::nullopt;
        }
        return BasisRecord{*matrix, step};
    }
    // As some files write them.
    static const std::map<std::string, std::string> otherSpellings = {
        {"bspline", "b-spline"}, {"catmullrom", "catmull-rom"}};
    const std::string &name = std::get<std::string>(basis);
    const auto other = otherSpellings.find(name);
    const auto found = standard.find(other == otherSpellings.end() ? name : other->second);
    if (found == standard.end()) {
        diagnostics.error(where, "Basis",
                          "'" + name +
                              "' is unknown: expected \"bezier\", \"b-spline\", "
                              "\"catmull-rom\", \"hermite\", \"power\" or 16 numbers");
        return std::nullopt;
    }
    return BasisRecord{found->second, step};
}

void StateHandlers::basis(const SourceLocation &where, const BasisArgument &u, int uStep,
                          const BasisArgument &v, int vStep) {
    auto uBasis = basisOf(diagnostics_, where, u, uStep),
         vBasis = basisOf(diagnostics_, where, v, vStep);
    if (!uBasis || !vBasis)
        return;
    state_.edit().uBasis = *uBasis;
    state_.edit().vBasis = *vBasis;
}

void StateHandlers::trimCurve(const SourceLocation &where, const Integers &curveCounts,
                              const Integers &orders, const Floats &knots, const Floats &minima,
                              const Floats &maxima, const Integers &pointCounts, const Floats &u,
                              const Floats &v, const Floats &w) {
    const TrimNumbers numbers{curveCounts, orders, pointCounts, knots, minima, maxima, u, v, w};
    std::string why;
    if (readTrim(numbers, why))
        keepTrim(numbers, state_.edit());
    else
        diagnostics_.error(where, "TrimCurve", why + "; the request is left out");
}

void StateHandlers::attribute(const SourceLocation &where, const std::string &category,
                              const TokenList &tokens) {
    for (Parameter &parameter : parameters_.ofCategory(tokens, "Attribute", category)) {
        if (!checkStateParameter(diagnostics_, where, "Attribute", category, parameter))
            continue;
        if (category == "identifier" && parameter.name == "name" && !parameter.strings.empty())
            state_.edit().name = parameter.strings.front();
        std::string name = category + ":" + parameter.name;
        Attributes &attributes = state_.edit(own::Named);
        if (object_.isOpen())
            attributes.ownNames.insert(name);
        attributes.named[std::move(name)] = std::move(parameter);
    }
}

} // namespace candela
