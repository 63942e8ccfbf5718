// SPDX-License-Identifier: Apache-2.0
// environment(): which way is which, no seam where a picture ends, whole poles, cube faces, blur.
#include "tests/textures/pictures.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

using Direction = std::array<double, 3>;

/// Smooth everywhere: what a direction shows.
double shown(const Direction &d, int channel) { return 0.5 + 0.4 * d[std::size_t(channel)]; }

void writeLatLong(const ScratchFolder &folder, const std::string &name) {
    writeExr(folder, name, 256, 128, {"R", "G", "B"}, [](int x, int y, int c) {
        const double longitude = 2 * std::numbers::pi * (x + 0.5) / 256;
        const double latitude = std::numbers::pi * (0.5 - (y + 0.5) / 128);
        return float(shown({std::cos(longitude) * std::cos(latitude),
                            std::sin(longitude) * std::cos(latitude), std::sin(latitude)},
                           c));
    });
}

void writeFaces(const ScratchFolder &folder) {
    const struct {
        const char *name;
        Direction forward, up, right;
    } faces[] = {{"px.exr", {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                 {"nx.exr", {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                 {"py.exr", {0, 1, 0}, {0, 0, -1}, {1, 0, 0}},
                 {"ny.exr", {0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
                 {"pz.exr", {0, 0, 1}, {0, 1, 0}, {1, 0, 0}},
                 {"nz.exr", {0, 0, -1}, {0, 1, 0}, {-1, 0, 0}}};
    const double half = std::tan(95 * std::numbers::pi / 360);
    for (const auto &face : faces)
        writeExr(folder, face.name, 64, 64, {"R", "G", "B"}, [&](int x, int y, int c) {
            const double right = ((x + 0.5) / 32 - 1) * half, up = (1 - (y + 0.5) / 32) * half;
            Direction d;
            double size = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                d[k] = face.forward[k] + right * face.right[k] + up * face.up[k];
                size += d[k] * d[k];
            }
            for (double &component : d)
                component /= std::sqrt(size);
            return float(shown(d, c));
        });
}

std::string inWords(const Direction &d) {
    return fmt::format("vector({:.6f}, {:.6f}, {:.6f})", d[0], d[1], d[2]);
}

/// All axes and corners; both sides of the seam (+x) and about the poles.
std::vector<Direction> directions() {
    std::vector<Direction> all;
    for (const double side : {1.0, -1.0}) {
        all.insert(all.end(), {{side, 0, 0}, {0, side, 0}, {0, 0, side}});
        all.insert(all.end(), {{1, side, -1}, {-1, side, side}});
        for (const double size : {1e-4, 0.02})
            all.insert(all.end(), {{size, size / 2, side}, {-size, size / 3, side}});
    }
    for (const double beside : {-0.02, -0.001, 1e-7, 0.02})
        all.push_back({2, beside, 0.3});
    return all;
}

TEST(Environments, ShowEveryDirectionWithoutSeamsAndWithWholePoles) {
    ScratchFolder folder;
    writeLatLong(folder, "sky.exr");
    writeFaces(folder);
    const std::string requests =
        "MakeLatLongEnvironment \"sky.exr\" \"sky.env\" \"box\" 1 1\n"
        "MakeCubeFaceEnvironment \"px.exr\" \"nx.exr\" \"py.exr\" \"ny.exr\" \"pz.exr\" \"nz.exr\" "
        "\"cube.env\" 95 \"box\" 1 1\n";
    for (const char *file : {"sky.exr", "sky.env", "cube.env"}) {
        std::vector<std::string> expressions;
        std::vector<double> expected;
        for (const Direction &d : directions())
            for (int channel = 0; channel < 3; ++channel) {
                const double size = std::hypot(d[0], d[1], d[2]);
                expressions.push_back(
                    fmt::format("float environment(\"{}\"[{}], {})", file, channel, inWords(d)));
                expected.push_back(shown({d[0] / size, d[1] / size, d[2] / size}, channel));
            }
        const Told told = tell(folder, {expressions, "", requests});
        EXPECT_EQ(told.run.status, 0) << told.run.text();
        ASSERT_EQ(told.values.size(), expressions.size()) << told.run.text();
        for (std::size_t k = 0; k < expressions.size(); ++k)
            EXPECT_NEAR(told.values[k], expected[k], 0.01) << expressions[k];
    }
}

TEST(Environments, BlurAndFourCornersAverage) {
    ScratchFolder folder;
    // White above the horizon, black below.
    writeExr(folder, "halves.exr", 128, 64, {"Y"},
             [](int, int y, int) { return y < 32 ? 1.0f : 0.0f; });
    const Told told =
        tell(folder, {{"float environment(\"halves.exr\", vector(1, 0, .2))",
                       "float environment(\"halves.exr\", vector(1, 0, 0))",
                       "float environment(\"halves.exr\", vector(1, 0, .2), \"blur\", 1)",
                       "float environment(\"halves.exr\", vector(1, 0, -.2), vector(0, 1, -.2), "
                       "vector(1, 0, .2), vector(0, 1, .2))",
                       "comp(color environment(\"halves.exr\", vector(0, 0, 5)), 2)"},
                      "",
                      ""});
    ASSERT_EQ(told.values.size(), 5u) << told.run.text();
    EXPECT_NEAR(told.values[0], 1, 1e-3);
    EXPECT_NEAR(told.values[1], 0.5, 0.05);
    EXPECT_NEAR(told.values[2], 0.5, 0.1);
    EXPECT_NEAR(told.values[3], 0.5, 0.05);
    EXPECT_NEAR(told.values[4], 1, 1e-3);
}

} // namespace
} // namespace candela::test
