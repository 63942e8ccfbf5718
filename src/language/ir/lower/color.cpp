// SPDX-License-Identifier: Apache-2.0
// Colour spaces and the paper's photometric functions. Conversions go by way of "rgb", linear
// Rec.709; hues are in [0,1).
#include "foundation/units/color.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/color.h"
#include "language/semantics/spellings.h"

#include <string_view>

namespace candela::ir {
namespace {

using Weights = float[3][3];

// CIE 1931 XYZ of linear Rec.709 primaries with white D65 (IEC 61966-2-1), and the inverse.
constexpr Weights xyzFromRgb = {{0.4123908f, 0.3575843f, 0.1804808f},
                                {0.2126390f, 0.7151687f, 0.0721923f},
                                {0.0193308f, 0.1191948f, 0.9505322f}};
constexpr Weights rgbFromXyz = {{3.2409699f, -1.5373832f, -0.4986108f},
                                {-0.9692436f, 1.8759675f, 0.0415551f},
                                {0.0556301f, -0.2039770f, 1.0569715f}};
// NTSC (FCC 1953) luma and chrominance, and the inverse.
constexpr Weights yiqFromRgb = {{0.299f, 0.587f, 0.114f},
                                {0.595716f, -0.274453f, -0.321263f},
                                {0.211456f, -0.522591f, 0.311135f}};
constexpr Weights rgbFromYiq = {
    {1, 0.9562948f, 0.6210251f}, {1, -0.2721214f, -0.6473811f}, {1, -1.1069899f, 1.7046149f}};

Triple linear(Builder &b, const Weights &rows, const Triple &c) {
    Triple result;
    for (int row = 0; row < 3; ++row) {
        const auto &w = rows[row];
        result[row] = dot(b, triple(b, w[0], w[1], w[2]), c);
    }
    return result;
}

ValueId modulo(Builder &b, ValueId x, float period) {
    const ValueId p = number(b, period);
    return sub(b, x, mul(b, p, unary(b, Op::Floor, div(b, x, p))));
}

struct Extremes {
    ValueId highest, lowest, range;
};

Extremes extremes(Builder &b, const Triple &c) {
    const ValueId highest = max(b, max(b, c[0], c[1]), c[2]);
    const ValueId lowest = min(b, min(b, c[0], c[1]), c[2]);
    return {highest, lowest, sub(b, highest, lowest)};
}

/// numerator / denominator, or 0 where the denominator is 0.
ValueId quotientOrZero(Builder &b, ValueId numerator, ValueId denominator) {
    const ValueId zero = number(b, 0);
    return select(b, equal(b, denominator, zero), zero, div(b, numerator, denominator));
}

ValueId hueOf(Builder &b, const Triple &c, const Extremes &e) {
    const auto sector = [&](float start, ValueId x, ValueId y) {
        return add(b, number(b, start), quotientOrZero(b, sub(b, x, y), e.range));
    };
    const ValueId nearGreen = sector(2, c[2], c[0]), nearBlue = sector(4, c[0], c[1]);
    const ValueId others = select(b, equal(b, c[1], e.highest), nearGreen, nearBlue);
    const ValueId sixths =
        select(b, equal(b, c[0], e.highest), modulo(b, sector(0, c[1], c[2]), 6), others);
    return div(b, sixths, number(b, 6));
}

Triple hsvFromRgb(Builder &b, const Triple &c) {
    const Extremes e = extremes(b, c);
    return {hueOf(b, c, e), quotientOrZero(b, e.range, e.highest), e.highest};
}

Triple hslFromRgb(Builder &b, const Triple &c) {
    const Extremes e = extremes(b, c);
    const ValueId one = number(b, 1), sum = add(b, e.highest, e.lowest);
    const ValueId fullRange = sub(b, one, unary(b, Op::Abs, sub(b, sum, one)));
    return {hueOf(b, c, e), quotientOrZero(b, e.range, fullRange), mul(b, sum, number(b, 0.5f))};
}

/// Each channel is v less a trapezium over the hue.
Triple rgbFromHsv(Builder &b, const Triple &c) {
    Triple result;
    const float shifts[3] = {5, 3, 1};
    const ValueId zero = number(b, 0), one = number(b, 1);
    for (int channel = 0; channel < 3; ++channel) {
        const ValueId k =
            modulo(b, add(b, number(b, shifts[channel]), mul(b, c[0], number(b, 6))), 6);
        const ValueId shape = max(b, zero, min(b, min(b, k, sub(b, number(b, 4), k)), one));
        result[channel] = sub(b, c[2], mul(b, mul(b, c[2], c[1]), shape));
    }
    return result;
}

Triple rgbFromHsl(Builder &b, const Triple &c) {
    Triple result;
    const float shifts[3] = {0, 8, 4};
    const ValueId one = number(b, 1);
    const ValueId reach = mul(b, c[1], min(b, c[2], sub(b, one, c[2])));
    for (int channel = 0; channel < 3; ++channel) {
        const ValueId k =
            modulo(b, add(b, number(b, shifts[channel]), mul(b, c[0], number(b, 12))), 12);
        const ValueId ramp = min(b, sub(b, k, number(b, 3)), sub(b, number(b, 9), k));
        result[channel] = sub(b, c[2], mul(b, reach, max(b, number(b, -1), min(b, ramp, one))));
    }
    return result;
}

Triple xyYFromXyz(Builder &b, const Triple &c) {
    const ValueId sum = add(b, add(b, c[0], c[1]), c[2]);
    return {quotientOrZero(b, c[0], sum), quotientOrZero(b, c[1], sum), c[1]};
}

Triple xyzFromXyY(Builder &b, const Triple &c) {
    const ValueId scale = quotientOrZero(b, c[2], c[1]);
    const ValueId z = sub(b, sub(b, number(b, 1), c[0]), c[1]);
    return {mul(b, c[0], scale), c[2], mul(b, z, scale)};
}

struct ColorSpace {
    std::string_view name;
    Triple (*fromRgb)(Builder &, const Triple &);
    Triple (*toRgb)(Builder &, const Triple &);
};

const ColorSpace colorSpaces[] = {
    {"rgb", [](Builder &, const Triple &c) { return c; },
     [](Builder &, const Triple &c) { return c; }},
    {"hsv", hsvFromRgb, rgbFromHsv},
    {"hsl", hslFromRgb, rgbFromHsl},
    {"XYZ", [](Builder &b, const Triple &c) { return linear(b, xyzFromRgb, c); },
     [](Builder &b, const Triple &c) { return linear(b, rgbFromXyz, c); }},
    {"xyY", [](Builder &b, const Triple &c) { return xyYFromXyz(b, linear(b, xyzFromRgb, c)); },
     [](Builder &b, const Triple &c) { return linear(b, rgbFromXyz, xyzFromXyY(b, c)); }},
    {"YIQ", [](Builder &b, const Triple &c) { return linear(b, yiqFromRgb, c); },
     [](Builder &b, const Triple &c) { return linear(b, rgbFromYiq, c); }},
};

const ColorSpace *findColorSpace(std::string_view name) {
    const std::string_view standard = sl::colorSpaceSpelled(name);
    for (const ColorSpace &space : colorSpaces)
        if (space.name == standard)
            return &space;
    return nullptr;
}

Components ctransform(BuiltinCall &call) {
    const size_t last = call.count() - 1;
    const std::string from = last == 2 ? call.text(0, "the name of a colour space") : "rgb";
    const std::string to = call.text(last - 1, "the name of a colour space");
    const Triple numbers = rgbOf(call.b, call.arguments[last]);
    return colorOf(call.b, convertColor(call.lowering, numbers, from, to, call.expr.where));
}

/// By samples: the factor is the same for all.
Components scaled(BuiltinCall &call, float factor) {
    Components result;
    for (const ValueId sample : call.arguments[0])
        result.push_back(mul(call.b, sample, number(call.b, factor)));
    return result;
}

Components photometric(BuiltinCall &call) { return scaled(call, luminousEfficacy); }

Components radiometric(BuiltinCall &call) { return scaled(call, 1 / luminousEfficacy); }

Components totalluminance(BuiltinCall &call) {
    Builder &b = call.b;
    return {mul(b, luminanceOf(b, call.arguments[0]), number(b, luminousEfficacy))};
}

/// The mean: one unit of each primary is one W m^-2 sr^-1 over the whole band.
Components totalradiance(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple c = rgbOf(b, call.arguments[0]);
    return {div(b, add(b, add(b, c[0], c[1]), c[2]), number(b, 3))};
}

} // namespace

Triple rgbOf(Builder &b, const Components &samples) {
    const ColorBasis &basis = b.colors();
    if (basis.isRgb())
        return tripleOf(samples);
    Triple rgb;
    for (int primary = 0; primary < 3; ++primary) {
        const auto &weights = basis.rgbFromSamples[primary];
        rgb[primary] = mul(b, samples[0], number(b, weights[0]));
        for (size_t k = 1; k < samples.size(); ++k)
            rgb[primary] = add(b, rgb[primary], mul(b, samples[k], number(b, weights[k])));
    }
    return rgb;
}

Components colorOf(Builder &b, const Triple &rgb) {
    const ColorBasis &basis = b.colors();
    if (basis.isRgb())
        return componentsOf(rgb);
    Components samples;
    for (const auto &weights : basis.samplesFromRgb)
        samples.push_back(dot(b, triple(b, weights[0], weights[1], weights[2]), rgb));
    return samples;
}

ValueId luminanceOf(Builder &b, const Components &value) {
    if (value.size() == 1 && b.colors().samples != 1)
        return value[0];
    const std::vector<float> weights = b.colors().luminance();
    ValueId sum = mul(b, value[0], number(b, weights[0]));
    for (size_t k = 1; k < value.size(); ++k)
        sum = add(b, sum, mul(b, value[k], number(b, weights[k])));
    return sum;
}

Triple convertColor(Lowering &lowering, const Triple &value, const std::string &from,
                    const std::string &to, const sl::Place &where) {
    const ColorSpace *source = findColorSpace(from), *target = findColorSpace(to);
    if (!source || !target) {
        lowering.messages.warning(where, "there is no colour space \"" + (source ? to : from) +
                                             "\": the colour stays as it is; expected " +
                                             sl::colorSpaceNames);
        return value;
    }
    if (source == target)
        return value;
    Builder &b = lowering.b;
    return target->fromRgb(b, source->toRgb(b, value));
}

BuiltinLowering colorBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::ctransform: return ctransform;
    case sl::BuiltinId::photometric: return photometric;
    case sl::BuiltinId::radiometric: return radiometric;
    case sl::BuiltinId::totalluminance: return totalluminance;
    case sl::BuiltinId::totalradiance: return totalradiance;
    default: return nullptr;
    }
}

} // namespace candela::ir
