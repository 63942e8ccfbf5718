// SPDX-License-Identifier: Apache-2.0
// The error of two pictures that differ in their seeds alone, as JSON:
//   picture_error A.exr B.exr [ID] [--by C.exr ...]
// relMSE_Y = mean of (difference of luminance)^2 / 2 over (Y^2 + 0.01), Y being the mean of both;
// pixels with Y > 5 (they see a lamp) are left out. With ID, only pixels whose channel "id" has
// that value all over count; "last" stands for the largest one in the picture. With --by, Y is the
// mean of those pictures instead: noisy pictures then leave out no pixel that others keep.
// "wholeMean" and "wholeVariance" are those of all pixels, lamps included.
#include "image/picture_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

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

/// Of each pixel, the mean over the pictures.
std::vector<double> meanLuminance(const std::vector<Picture> &pictures) {
    std::vector<double> means(pictures.front().window.pixels());
    for (const Picture &picture : pictures)
        for (std::size_t i = 0; i < means.size(); ++i)
            means[i] += luminance(picture, i) / double(pictures.size());
    return means;
}

/// Sums over some of the pixels.
struct Sums {
    double relative = 0, variance = 0, a = 0, b = 0;
    std::size_t pixels = 0;

    void add(double ya, double yb, double y) {
        double square = (ya - yb) * (ya - yb) / 2;
        relative += square / (y * y + 0.01);
        variance += square;
        a += ya, b += yb;
        ++pixels;
    }
};

int report(const Picture &a, const Picture &b, const char *id, const std::vector<double> &ys) {
    std::vector<bool> chosen = chosenPixels(a, b, id);
    Sums part, whole;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        double ya = luminance(a, i), yb = luminance(b, i), y = ys[i];
        whole.add(ya, yb, y);
        if (chosen[i] && y <= lampLuminance)
            part.add(ya, yb, y);
    }
    if (part.pixels == 0) {
        std::fprintf(stderr, "picture_error: no pixels to compare\n");
        return 1;
    }
    double n = double(part.pixels), all = double(whole.pixels);
    std::printf("{\"pixels\": %zu, \"relMseY\": %.9g, \"variance\": %.9g, \"meanA\": %.9g, "
                "\"meanB\": %.9g,\n \"wholePixels\": %zu, \"wholeVariance\": %.9g, "
                "\"wholeMeanA\": %.9g, \"wholeMeanB\": %.9g}\n",
                part.pixels, part.relative / n, part.variance / n, part.a / n, part.b / n,
                whole.pixels, whole.variance / all, whole.a / all, whole.b / all);
    return 0;
}

/// \throws std::runtime_error when a file is no picture or not of the others' size.
std::vector<Picture> read(const std::vector<std::string> &files) {
    std::vector<Picture> pictures;
    for (const std::string &file : files) {
        std::string problem;
        std::optional<Picture> picture = readPicture(file, problem);
        if (!picture)
            throw std::runtime_error(problem);
        pictures.push_back(std::move(*picture));
        if (!(pictures.back().window == pictures.front().window))
            throw std::runtime_error("the pictures differ in size");
    }
    return pictures;
}

} // namespace
} // namespace candela::bench

int main(int argc, char **argv) try {
    using namespace candela::bench;
    std::vector<std::string> words(argv + 1, argv + argc);
    auto by = std::ranges::find(words, "--by");
    std::vector<std::string> files(words.begin(), by);
    if (files.size() < 2 || files.size() > 3 || (by != words.end() && by + 1 == words.end())) {
        std::fprintf(stderr, "usage: picture_error A.exr B.exr [ID] [--by C.exr ...]\n");
        return 2;
    }
    std::string id = files.size() > 2 ? files[2] : "";
    files.resize(2);
    if (by != words.end())
        files.insert(files.end(), by + 1, words.end());
    std::vector<candela::Picture> pictures = read(files);
    std::vector<double> ys = meanLuminance(
        files.size() > 2 ? std::vector<candela::Picture>(pictures.begin() + 2, pictures.end())
                         : pictures);
    return report(pictures[0], pictures[1], id.empty() ? nullptr : id.c_str(), ys);
} catch (const std::exception &problem) {
    std::fprintf(stderr, "picture_error: %s\n", problem.what());
    return 1;
}
