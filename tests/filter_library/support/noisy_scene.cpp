// SPDX-License-Identifier: Apache-2.0
#include "tests/filter_library/support/noisy_scene.h"

#include "tests/filter_library/support/filter_run.h"

#include <cmath>
#include <random>

namespace candela::filters {

namespace {

/// As the float that a filter is going to see.
double seen(double value) { return double(float(value)); }

Rgb albedoAt(int x, int y, bool floor) {
    const bool dark = (x / 3 + y / 3) % 2 != 0;
    if (floor)
        return dark ? Rgb{.08, .1, .15} : Rgb{.8, .75, .6};
    const double grain = .5 + .4 * std::sin(2.9 * x + 1.7 * y);
    return {.7 * grain, .4 * grain, .3 * grain};
}

double lightAt(int x, int y) {
    const double shadow = 1 / (1 + std::exp(-.9 * (x - .6 * y - 6)));
    return .3 + shadow + .01 * y;
}

/// Samples of a skew distribution about 1.
struct Pixel {
    double mean, variance;
};

Pixel samplePixel(std::mt19937 &random, int samples) {
    double sum = 0, squares = 0;
    for (int s = 0; s < samples; ++s) {
        const double u = double(random()) / 4294967296.;
        const double value = u < .1 ? 3.6 : .2 + u;
        sum += value;
        squares += value * value;
    }
    const double mean = sum / samples;
    return {mean, (squares / samples - mean * mean) / (samples - 1)};
}

Picture asFloats(const Picture &picture) {
    return makePicture(picture.width, picture.height, [&](int x, int y) {
        const Rgb &c = picture.at(x, y);
        return Rgb{seen(c[0]), seen(c[1]), seen(c[2])};
    });
}

} // namespace

ImageMaps NoisyScene::maps() const {
    ImageMaps maps = mapsOf(color);
    putInto(maps);
    return maps;
}

void NoisyScene::putInto(ImageMaps &maps) const {
    setMap(maps, "Ci", color);
    setMap(maps, "variance", variance);
    setMap(maps, "N", normal);
    setMap(maps, "albedo", albedo);
    maps.set("id", OwnedImage(id.width, id.height, 1));
    std::vector<float> plane;
    for (const Rgb &pixel : id.pixels)
        plane.push_back(float(pixel[0]));
    maps.setPlane("id", 0, plane);
}

NoisyScene noisyScene(int width, int height, int samples) {
    std::mt19937 random(7);
    const Picture empty(width, height);
    NoisyScene scene{empty, empty, empty, empty, empty, empty};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool floor = y > .6 * height;
            const Rgb albedo = albedoAt(x, y, floor);
            const Pixel noise = samplePixel(random, samples);
            scene.albedo.at(x, y) = albedo;
            scene.normal.at(x, y) = floor ? Rgb{0, 1, 0} : Rgb{0, 0, -1};
            scene.id.at(x, y) = {floor ? 2. : 1., 0, 0};
            for (int c = 0; c < 3; ++c) {
                const double value = albedo[c] * lightAt(x, y);
                scene.clean.at(x, y)[c] = value;
                scene.color.at(x, y)[c] = value * noise.mean;
                scene.variance.at(x, y)[c] = value * value * noise.variance;
            }
        }
    for (Picture *picture : {&scene.color, &scene.variance, &scene.albedo})
        *picture = asFloats(*picture);
    return scene;
}

Picture mirrored(const Picture &picture) {
    return makePicture(picture.width, picture.height,
                       [&](int x, int y) { return picture.at(picture.width - 1 - x, y); });
}

NoisyScene mirrored(const NoisyScene &scene) {
    return {mirrored(scene.color),  mirrored(scene.clean),  mirrored(scene.variance),
            mirrored(scene.normal), mirrored(scene.albedo), mirrored(scene.id)};
}

double squaredError(const Picture &a, const Picture &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            sum += (a.pixels[i][c] - b.pixels[i][c]) * (a.pixels[i][c] - b.pixels[i][c]);
    return sum / (3 * double(a.pixels.size()));
}

} // namespace candela::filters
