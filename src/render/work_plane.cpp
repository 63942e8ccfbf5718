// SPDX-License-Identifier: Apache-2.0
#include "render/work_plane.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace candela {

namespace {

using Triple = std::array<double, 3>;

Triple crossOf(const Triple &a, const Triple &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double lengthOf(const Triple &a) { return std::hypot(a[0], a[1], a[2]); }

const char *unitOf(ProbeQuantity quantity) {
    return quantity == ProbeQuantity::Irradiance ? "lx" : "cd/m^2";
}

} // namespace

std::vector<ProbePoint> WorkPlane::points() const {
    Triple normal = crossOf(u, v);
    for (double &component : normal)
        component = turned ? -component : component;
    std::vector<ProbePoint> result;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double s = (column + 0.5) / columns, t = (rows - row - 0.5) / rows;
            ProbePoint point{{}, normal, int(result.size()) + 1};
            for (std::size_t c = 0; c < 3; ++c)
                point.P[c] = corner[c] + s * u[c] + t * v[c];
            result.push_back(point);
        }
    return result;
}

std::string WorkPlane::flaw() const {
    constexpr double farthest = 1e15, leastSine = 1e-6;
    for (const Triple &triple : {corner, u, v})
        for (double value : triple)
            if (!(std::fabs(value) <= farthest))
                return fmt::format("coordinates are numbers within {:g}", farthest);
    if (!(lengthOf(crossOf(u, v)) > leastSine * lengthOf(u) * lengthOf(v)))
        return "the edges u and v lie on one line: they have to span a plane";
    return "";
}

std::string tableOf(const WorkPlane &plane, ProbeQuantity quantity,
                    std::span<const ProbeAnswer> answers) {
    std::string text;
    double sum = 0, least = INFINITY, largest = 0, widest = 0;
    for (std::size_t k = 0; k < answers.size(); ++k) {
        const double value = answers[k].photometric;
        text += fmt::format("{:>9.4g}{}", value, int(k + 1) % plane.columns == 0 ? "\n" : " ");
        sum += value;
        least = std::min(least, value), largest = std::max(largest, value);
        widest = std::max(widest, value > 0 ? answers[k].halfWidth / value : 0);
    }
    const double mean = sum / double(answers.size());
    return text + fmt::format("mean {:.5g}, least {:.5g}, largest {:.5g} {}; least/mean {:.3g}; "
                              "widest interval +-{:.2g} %\n",
                              mean, least, largest, unitOf(quantity), mean > 0 ? least / mean : 0,
                              100 * widest);
}

Picture pictureOf(const WorkPlane &plane, ProbeQuantity quantity,
                  std::span<const ProbeAnswer> answers) {
    const bool irradiance = quantity == ProbeQuantity::Irradiance;
    Picture picture;
    picture.window = {plane.columns, plane.rows, 0, plane.columns, 0, plane.rows};
    for (int c = 0; c < 3; ++c)
        picture.channels.push_back({std::string(1, "RGB"[c]), {}});
    picture.channels.push_back({irradiance ? "illuminance" : "luminance", {}});
    picture.channels.push_back({"halfwidth", {}});
    picture.channels.push_back({"samples", {}});
    for (const ProbeAnswer &answer : answers) {
        for (int c = 0; c < 3; ++c)
            picture.channels[std::size_t(c)].values.push_back(float(answer.value[std::size_t(c)]));
        picture.channels[3].values.push_back(float(answer.photometric));
        picture.channels[4].values.push_back(float(answer.halfWidth));
        picture.channels[5].values.push_back(float(answer.samples));
    }
    picture.metadata = {{"renderer", "Candela"},
                        {"quantity", irradiance ? "irradiance" : "radiance"},
                        {"units", irradiance ? "W m^-2; illuminance and halfwidth in lx"
                                             : "W m^-2 sr^-1; luminance and halfwidth in cd m^-2"},
                        {"lm_per_W", fmt::format("{:g}", luminousEfficacy)}};
    return picture;
}

Picture enlarged(const WorkPlane &plane, const Picture &picture) {
    constexpr double longer = 480, shorter = 120, most = 4096;
    const double ratio = lengthOf(plane.u) * plane.rows / (plane.columns * lengthOf(plane.v));
    // Pixels of a cell up and down, of cells `ratio` times as wide as high.
    double high = std::max({longer / std::max(plane.columns * ratio, double(plane.rows)),
                            shorter / (plane.columns * ratio), shorter / plane.rows});
    high = std::min({high, most / (plane.columns * ratio), most / plane.rows});
    const int rowPixels = std::max(1, int(std::lround(high)));
    const int columnPixels = std::max(1, int(std::lround(high * ratio)));
    const int width = plane.columns * columnPixels, height = plane.rows * rowPixels;
    Picture result;
    result.window = {width, height, 0, width, 0, height};
    for (const PictureChannel &channel : picture.channels) {
        if (channel.name.size() > 1)
            continue;
        PictureChannel &to = result.channels.emplace_back(PictureChannel{channel.name, {}});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                to.values.push_back(
                    channel.values[std::size_t(y / rowPixels * plane.columns + x / columnPixels)]);
    }
    result.metadata = picture.metadata;
    return result;
}

} // namespace candela
