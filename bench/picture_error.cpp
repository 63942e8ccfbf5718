// SPDX-License-Identifier: Apache-2.0
// The error of two pictures that differ in their seeds alone, as JSON:
//   picture_error A.exr B.exr [ID]
// relMSE_Y = mean of (difference of luminance)^2 / 2 over (Y^2 + 0.01), Y being the mean of both;
// pixels with Y > 5 (they see a lamp) are left out. With ID, only pixels whose channel "id" has
// that value all over count; "last" stands for the largest one in the picture.
#include "image/picture_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace candela::bench {
namespace {

constexpr double lampLuminance = 5;

double luminance(const Picture &picture, std::size_t pixel) {
    static constexpr struct {
        const char *name;
        double weight;
    } parts[] = {{"R", .2126}, {"G", .7152}, {"B", .0722}};
    double sum = 0;
    for (auto [name, weight] : parts)
        if (const PictureChannel *channel = picture.find(name))
            sum += weight * channel->values[pixel];
    return sum;
}

/// The pixels that count: all, or those of one primitive in both pictures.
std::vector<bool> chosenPixels(const Picture &a, const Picture &b, const char *id) {
    std::vector<bool> chosen(a.window.pixels(), true);
    const PictureChannel *idA = a.find("id"), *idB = b.find("id");
    if (!id)
        return chosen;
    if (!idA || !idB || idA->values.empty())
        return std::vector<bool>(a.window.pixels(), false);
    float wanted = std::string_view(id) == "last" ? *std::ranges::max_element(idA->values)
                                                  : std::strtof(id, nullptr);
    for (std::size_t i = 0; i < chosen.size(); ++i)
        chosen[i] = idA->values[i] == wanted && idB->values[i] == wanted;
    return chosen;
}

int report(const Picture &a, const Picture &b, const char *id) {
    std::vector<bool> chosen = chosenPixels(a, b, id);
    double relative = 0, variance = 0, meanA = 0, meanB = 0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        double ya = luminance(a, i), yb = luminance(b, i), y = (ya + yb) / 2;
        if (!chosen[i] || !(y <= lampLuminance))
            continue;
        double square = (ya - yb) * (ya - yb) / 2;
        relative += square / (y * y + 0.01);
        variance += square;
        meanA += ya, meanB += yb;
        ++pixels;
    }
    if (pixels == 0) {
        std::fprintf(stderr, "picture_error: no pixels to compare\n");
        return 1;
    }
    double n = double(pixels);
    std::printf("{\"pixels\": %zu, \"relMseY\": %.9g, \"variance\": %.9g, \"meanA\": %.9g, "
                "\"meanB\": %.9g}\n",
                pixels, relative / n, variance / n, meanA / n, meanB / n);
    return 0;
}

} // namespace
} // namespace candela::bench

int main(int argc, char **argv) {
    using namespace candela;
    if (argc < 3 || argc > 4) {
        std::fprintf(stderr, "usage: picture_error A.exr B.exr [ID]\n");
        return 2;
    }
    std::string problem;
    std::optional<Picture> a = readPicture(argv[1], problem);
    std::optional<Picture> b = a ? readPicture(argv[2], problem) : std::nullopt;
    if (a && b && !(a->window == b->window))
        problem = "the pictures differ in size";
    if (!a || !b || !problem.empty()) {
        std::fprintf(stderr, "picture_error: %s\n", problem.c_str());
        return 1;
    }
    return bench::report(*a, *b, argc > 3 ? argv[3] : nullptr);
}
