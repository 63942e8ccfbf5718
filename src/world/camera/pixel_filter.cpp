// SPDX-License-Identifier: Apache-2.0
#include "world/camera/pixel_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

using std::numbers::pi;

double sincKernel(double x) { return x == 0 ? 1 : std::sin(pi * x) / (pi * x); }

/// B = C = 1/3, on [-2, 2] (Mitchell and Netravali 1988).
double mitchellKernel(double x) {
    x = std::abs(x);
    if (x >= 2)
        return 0;
    if (x >= 1)
        return ((-7.0 / 3 * x + 12) * x - 20) * x / 6 + 16.0 / 9;
    return ((7 * x - 12) * x * x + 16.0 / 3) / 6;
}

double catmullRomKernel(double r) {
    if (r >= 2)
        return 0;
    return r < 1 ? (3 * r - 5) * r * r + 2 : ((-r + 5) * r - 8) * r + 4;
}

/// The four-term window of Harris 1978 on [-1, 1].
double blackmanHarrisKernel(double x) {
    return 0.35875 + 0.48829 * std::cos(pi * x) + 0.14128 * std::cos(2 * pi * x) +
           0.01168 * std::cos(3 * pi * x);
}

/// The radial counterpart of sinc: the transform of a disc.
double besselKernel(double r) { return r == 0 ? 1 : 2 * std::cyl_bessel_j(1.0, pi * r) / (pi * r); }

/// One factor of a separable kernel, or a radial profile. `t` is the distance in half-widths,
/// within [-1, 1]; `x` is the distance in pixels.
struct Kernel {
    std::string_view name;
    bool radial;
    double (*value)(double t, double x);
};

constexpr std::array<Kernel, 9> kernels{{
    {"box", false, [](double, double) { return 1.0; }},
    {"triangle", false, [](double t, double) { return 1 - std::abs(t); }},
    {"gaussian", false, [](double t, double) { return std::exp(-2 * t * t); }},
    {"sinc", false, [](double, double x) { return sincKernel(x); }},
    {"mitchell", false, [](double t, double) { return mitchellKernel(2 * t); }},
    {"blackman-harris", false, [](double t, double) { return blackmanHarrisKernel(t); }},
    {"catmull-rom", true, [](double, double r) { return catmullRomKernel(r); }},
    {"disk", true, [](double, double) { return 1.0; }},
    {"bessel", true, [](double, double r) { return besselKernel(r); }},
}};

const Kernel *findKernel(std::string_view name) {
    auto found = std::ranges::find(kernels, name, &Kernel::name);
    return found == kernels.end() ? nullptr : &*found;
}

double meanRadius(const PixelFilterRecord &f) { return (double(f.xWidth) + f.yWidth) / 4; }

/// Cells of the tabulated density: the error of a filtered smooth function is below 1e-5.
constexpr int cellCount = 512;
/// Steps of the integral within a cell.
constexpr int stepsPerCell = 32;
constexpr int guideSteps = 4096;

PixelFilterRecord checked(const PixelFilterRecord &record, DiagnosticSink &sink,
                          const SourceLocation &where) {
    const auto usable = [](float width) { return width > 0 && width <= 1000; };
    if (!findKernel(record.name)) {
        std::string known;
        for (std::string_view name : PixelFilterSampler::knownNames())
            known += (known.empty() ? "" : ", ") + std::string(name);
        sink.error(where, "unknown pixel filter \"" + record.name +
                              "\": gaussian 2 2 is used; known are " + known);
        return {};
    }
    if (!usable(record.xWidth) || !usable(record.yWidth)) {
        sink.error(where, "the widths of pixel filter \"" + record.name +
                              "\" must be positive and at most 1000 pixels: gaussian 2 2 is used");
        return {};
    }
    return record;
}

} // namespace

double pixelFilterKernel(const PixelFilterRecord &f, double dx, double dy) {
    const Kernel *kernel = findKernel(f.name);
    const double s = dx / (f.xWidth / 2.0), t = dy / (f.yWidth / 2.0);
    if (!kernel || std::abs(s) > 1 || std::abs(t) > 1)
        return 0;
    if (!kernel->radial)
        return kernel->value(s, dx) * kernel->value(t, dy);
    const double r = std::hypot(s, t);
    return r > 1 ? 0 : kernel->value(r, r * meanRadius(f));
}

std::vector<std::string_view> PixelFilterSampler::knownNames() {
    std::vector<std::string_view> names;
    for (const Kernel &kernel : kernels)
        names.push_back(kernel.name);
    return names;
}

float PixelFilterSampler::Axis::at(float u) const {
    int i = guide[std::clamp(int(u * guideSteps), 0, guideSteps - 1)];
    while (i < cellCount - 1 && cumulative[i + 1] <= u)
        ++i;
    const float mass = cumulative[i + 1] - cumulative[i];
    const float part = mass > 0 ? std::clamp((u - cumulative[i]) / mass, 0.0f, 1.0f) : 0.0f;
    return from + (i + part) * cellWidth;
}

float PixelFilterSampler::Axis::signAt(float u) const {
    float sign = firstSign;
    for (float flip : flips)
        if (u >= flip)
            sign = -sign;
    return sign;
}

/// Radial tables take the square root of the share of the disc as their argument, which keeps the
/// inverse smooth (nearly linear) at the centre.
template <class Density>
PixelFilterSampler::Axis PixelFilterSampler::tabulate(double from, double to, bool radial,
                                                      const Density &density) {
    constexpr int steps = cellCount * stepsPerCell;
    const double step = (to - from) / steps;
    std::vector<double> cellShare{0}, flipShare;
    double share = 0, sum = 0, lastSign = 0;
    Axis axis;
    axis.from = float(from);
    axis.cellWidth = float((to - from) / cellCount);
    for (int i = 0; i < steps; ++i) {
        const double value = density(from + (i + 0.5) * step);
        const double sign = value < 0 ? -1 : value > 0 ? 1 : lastSign;
        if (lastSign == 0 && sign != 0)
            axis.firstSign = float(sign);
        else if (sign != lastSign)
            flipShare.push_back(share);
        lastSign = sign;
        share += std::abs(value);
        sum += value;
        if ((i + 1) % stepsPerCell == 0)
            cellShare.push_back(share);
    }
    const auto argument = [&](double s) {
        return float(radial ? std::sqrt(s / share) : s / share);
    };
    for (double s : flipShare)
        axis.flips.push_back(argument(s));
    for (double s : cellShare)
        axis.cumulative.push_back(argument(s));
    axis.scale = float(share / sum);
    for (int k = 0, cell = 0; k < guideSteps; ++k) {
        while (cell < cellCount - 1 && axis.cumulative[cell + 1] <= float(k) / guideSteps)
            ++cell;
        axis.guide.push_back(std::uint16_t(cell));
    }
    return axis;
}

PixelFilterSampler::PixelFilterSampler(const PixelFilterRecord &asked, DiagnosticSink &sink,
                                       SourceLocation where)
    : record_(checked(asked, sink, where)) {
    const Kernel &kernel = *findKernel(record_.name);
    uniform_ = kernel.name == "box";
    radial_ = kernel.radial;
    if (uniform_)
        return;
    if (radial_) {
        const double radius = meanRadius(record_);
        x_ = tabulate(0, 1, true, [&](double t) { return kernel.value(t, t * radius) * t; });
        return;
    }
    const auto axis = [&](double half) {
        return tabulate(-half, half, false, [&](double x) { return kernel.value(x / half, x); });
    };
    x_ = axis(record_.xWidth / 2.0);
    y_ = axis(record_.yWidth / 2.0);
}

FilterSample PixelFilterSampler::sampleTables(float u, float v) const {
    if (!radial_)
        return {x_.at(u), y_.at(v), x_.signAt(u) * y_.signAt(v) * x_.scale * y_.scale};
    // The square is folded onto the disc ring by ring (Shirley and Chiu 1997), so that strips of
    // the square stay compact; `ring` squared is uniform.
    const float a = 2 * u - 1, b = 2 * v - 1;
    const bool sideways = std::abs(a) > std::abs(b);
    const float ring = sideways ? a : b;
    if (ring == 0)
        return {0, 0, x_.signAt(0) * x_.scale};
    const float quarter = float(pi / 4) * (sideways ? b / a : a / b);
    const float along = std::cos(quarter), across = std::sin(quarter);
    const float radius = std::copysign(x_.at(std::abs(ring)), ring);
    const float s = radius * (sideways ? along : across), t = radius * (sideways ? across : along);
    return {s * record_.xWidth / 2, t * record_.yWidth / 2, x_.signAt(std::abs(ring)) * x_.scale};
}

} // namespace candela
