// SPDX-License-Identifier: Apache-2.0
// The error of pictures against a converged one that is known twice, from two seeds, as JSON:
//   denoise_error REFERENCE_A.exr REFERENCE_B.exr PICTURE.exr ...
// Squared error is (picture - A)(picture - B): the references' own noise cancels. For each picture:
//   "mse"      mean over R, G, B of all pixels
//   "noLamps"  the same without pixels that see a lamp, or some of it (Y > 1)
//   "relMseY"  mean of the error of Y over (Y^2 + .01), without pixels of Y > 5 (README.md)
//   "texture"  of what differs from the mean of three by three pixels, where albedo does: squared
//              error over its own square; the first reference carries "albedo"
//   "kept"     how much of it there is: 1 all, 0 nothing
#include "image/picture_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace candela::bench {
namespace {

struct Image {
    int width = 0, height = 0;
    std::array<std::vector<float>, 3> planes, albedo;
};

Image read(const std::string &file) {
    std::string problem;
    std::optional<Picture> picture = readPicture(file, problem);
    if (!picture)
        throw std::runtime_error(problem);
    Image image{picture->window.columns(), picture->window.rows(), {}, {}};
    const char *names[] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        const PictureChannel *color = picture->find(names[c]);
        if (!color)
            throw std::runtime_error(file + ": no channel " + names[c]);
        image.planes[std::size_t(c)] = color->values;
        if (const PictureChannel *albedo = picture->find(std::string("albedo.") + names[c]))
            image.albedo[std::size_t(c)] = albedo->values;
    }
    return image;
}

double luminance(const Image &image, std::size_t at) {
    return .2126 * image.planes[0][at] + .7152 * image.planes[1][at] + .0722 * image.planes[2][at];
}

/// What a pixel has that the mean of three by three does not; inner pixels.
double detail(const Image &image, const std::vector<float> &plane, std::size_t at) {
    double sum = 0;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            sum += plane[at + std::size_t(j * image.width + i)];
    return plane[at] - sum / 9;
}

struct Errors {
    double all = 0, noLamps = 0, relative = 0, texture = 0, kept = 0, own = 0;
    std::size_t pixels = 0, dark = 0, counted = 0;
};

void addColors(Errors &sum, const Image &a, const Image &b, const Image &found, std::size_t at) {
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c)
        error += double(found.planes[c][at] - a.planes[c][at]) *
                 double(found.planes[c][at] - b.planes[c][at]) / 3;
    const double ya = luminance(a, at), yb = luminance(b, at), y = (ya + yb) / 2;
    sum.all += error, ++sum.pixels;
    if (y <= 1)
        sum.noLamps += error, ++sum.dark;
    if (y <= 5) {
        const double yf = luminance(found, at);
        sum.relative += (yf - ya) * (yf - yb) / (y * y + .01), ++sum.counted;
    }
}

void addTexture(Errors &sum, const Image &a, const Image &b, const Image &found, std::size_t at) {
    if (luminance(a, at) > 1)
        return;
    for (std::size_t c = 0; c < 3; ++c) {
        if (a.albedo[c].empty() || std::abs(detail(a, a.albedo[c], at)) < .02)
            continue;
        const double da = detail(a, a.planes[c], at), db = detail(b, b.planes[c], at);
        const double df = detail(found, found.planes[c], at);
        sum.texture += (df - da) * (df - db);
        sum.kept += df * (da + db) / 2;
        sum.own += da * db;
    }
}

void report(const std::string &name, const Image &a, const Image &b, const Image &found) {
    if (found.width != a.width || found.height != a.height)
        throw std::runtime_error(name + ": of another size than the references");
    Errors sum;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const auto at = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
            addColors(sum, a, b, found, at);
            if (x > 0 && y > 0 && x < a.width - 1 && y < a.height - 1)
                addTexture(sum, a, b, found, at);
        }
    std::printf("{\"picture\": \"%s\", \"mse\": %.6g, \"noLamps\": %.6g, \"relMseY\": %.6g, "
                "\"texture\": %.6g, \"kept\": %.6g}\n",
                name.c_str(), sum.all / double(sum.pixels),
                sum.noLamps / double(std::max<std::size_t>(sum.dark, 1)),
                sum.relative / double(std::max<std::size_t>(sum.counted, 1)),
                sum.own > 0 ? sum.texture / sum.own : 0, sum.own > 0 ? sum.kept / sum.own : 0);
}

} // namespace
} // namespace candela::bench

int main(int argc, char **argv) try {
    using namespace candela::bench;
    if (argc < 4) {
        std::fprintf(stderr,
                     "usage: denoise_error REFERENCE_A.exr REFERENCE_B.exr PICTURE.exr ...\n");
        return 2;
    }
    const Image a = read(argv[1]), b = read(argv[2]);
    for (int k = 3; k < argc; ++k)
        report(argv[k], a, b, read(argv[k]));
} catch (const std::exception &problem) {
    std::fprintf(stderr, "denoise_error: %s\n", problem.what());
    return 1;
}
