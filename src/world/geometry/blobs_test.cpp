// SPDX-License-Identifier: Apache-2.0
// Blobbies against closed forms: single blobs, what combines them, and programs that are wrong.
#include "world/geometry/blob_mesh.h"
#include "world/geometry/test_support.h"

#include <cmath>
#include <ctime>
#include <map>

namespace candela {
namespace {

using namespace geometrytest;

/// Rows of a matrix that scales and moves.
std::vector<float> placed(float x, float y, float z, float sx, float sy, float sz) {
    return {sx, 0, 0, 0, 0, sy, 0, 0, 0, 0, sz, 0, x, y, z, 1};
}

std::vector<float> together(std::initializer_list<std::vector<float>> parts) {
    std::vector<float> all;
    for (const auto &part : parts)
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

BlobField fieldOf(const BlobbyRecord &record) {
    DiagnosticList diagnostics;
    auto field = BlobField::make(record, {}, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    return field.value_or(BlobField{});
}

DicedMesh asMesh(const BlobMesh &mesh) { return {mesh.positions, mesh.triangles, {}, {}, 0}; }

/// Every edge is passed as often one way as the other. Where fields meet in creases, two sheets may
/// share an edge.
bool isClosed(const BlobMesh &mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
    for (const auto &t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k], b = t[(k + 1) % 3];
            balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
        }
    return std::ranges::all_of(balance, [](const auto &edge) { return edge.second == 0; });
}

TEST(Blobs, OneIsAnEllipsoidHalfAsLarge) {
    for (float scale : {1e-3f, 1.0f, 500.0f}) {
        const BlobMesh mesh = meshOf(
            fieldOf({1, {1001, 0}, placed(3 * scale, 0, 0, scale, 2 * scale, 2 * scale), {}}));
        ASSERT_GT(mesh.triangles.size(), 500u);
        EXPECT_EQ(borderEdges(asMesh(mesh)), 0);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vec3 p = mesh.positions[i] - Vec3{3 * scale, 0, 0};
            const Vec3 unit = Vec3{p.x / (0.5f * scale), p.y / scale, p.z / scale};
            EXPECT_NEAR(length(unit), 1, 2e-4);
            const Vec3 normal = normalize(Vec3{4 * p.x, p.y, p.z});
            EXPECT_LT(length(mesh.normals[i] - normal), 2e-3);
        }
        // An oblate spheroid of half axes a, a and c, by its eccentricity.
        const double a = scale, c = 0.5 * scale, e = std::sqrt(1 - c * c / (a * a));
        const double area = 2 * std::numbers::pi * a * a * (1 + (1 - e * e) / e * std::atanh(e));
        EXPECT_NEAR(areaOf(asMesh(mesh)) / area, 1, 5e-3);
    }
}

TEST(Blobs, SegmentsAreSausages) {
    const auto matrix = placed(0, 1, 0, 2, 2, 2);
    const BlobMesh mesh =
        meshOf(fieldOf({1, {1002, 0}, together({{-1, 0, 0, 1, 0, 0, 0.5f}, matrix}), {}}));
    EXPECT_EQ(borderEdges(asMesh(mesh)), 0);
    // In object space the segment is 4 long and the radius 1, so the surface is .5 from it.
    EXPECT_NEAR(areaOf(asMesh(mesh)) / (std::numbers::pi * (4 + 4 * 0.25)), 1, 5e-3);
    for (Vec3 p : mesh.positions) {
        const float beyond = std::max(std::fabs(p.x) - 2, 0.0f);
        EXPECT_NEAR(std::hypot(beyond, std::hypot(p.y - 1, p.z)), 0.5f, 1e-3);
    }
}

struct Combination {
    const char *name;
    std::vector<int> codes;
    double radius; ///< About the origin, of the surface.
};

TEST(Blobs, CombineAsTheirCodesSay) {
    const double t = 27.0 / 64;
    // f = (1 - r^2)^3 is the field of each of two blobs at the origin.
    auto whereFieldIs = [](double value) { return std::sqrt(1 - std::cbrt(value)); };
    const Combination combinations[] = {
        {"add", {1001, 0, 1001, 0, 0, 2, 0, 1}, whereFieldIs(t / 2)},
        {"multiply", {1001, 0, 1001, 0, 1, 2, 0, 1}, whereFieldIs(std::sqrt(t))},
        {"maximum", {1001, 0, 1001, 0, 2, 2, 0, 1}, 0.5},
        {"minimum", {1001, 0, 1001, 0, 3, 2, 0, 1}, 0.5},
        {"subtract", {1001, 0, 1000, 16, 4, 0, 1}, whereFieldIs(t + 0.25)},
        {"divide", {1001, 0, 1000, 17, 5, 0, 1}, whereFieldIs(t * 2)},
        {"negate twice", {1001, 0, 6, 0, 6, 1}, 0.5},
        {"identity", {1001, 0, 7, 0}, 0.5},
        {"subtract and add", {1001, 0, 1000, 16, 4, 0, 1, 0, 2, 2, 1}, 0.5},
    };
    for (const Combination &combination : combinations) {
        const auto floats = together({placed(0, 0, 0, 1, 1, 1), {0.25f, 2}});
        DiagnosticList ignored; // Of the number of leaves.
        const auto field = BlobField::make({2, combination.codes, floats, {}}, {}, ignored);
        ASSERT_TRUE(field) << combination.name << ignored.text();
        const BlobMesh mesh = meshOf(*field);
        ASSERT_GT(mesh.triangles.size(), 500u) << combination.name;
        for (Vec3 p : mesh.positions)
            ASSERT_NEAR(length(p), combination.radius, 1e-3) << combination.name;
    }
}

/// Twelve blobs in a row with all kinds of codes about them.
BlobbyRecord chain() {
    BlobbyRecord record;
    record.leaves = 12;
    for (int i = 0; i < 12; ++i) {
        record.codes.insert(record.codes.end(), {1001, 16 * i});
        const auto matrix = placed(0.7f * float(i), 0.2f * float(i % 3), 0, 1, 0.8f, 1.2f);
        record.floats.insert(record.floats.end(), matrix.begin(), matrix.end());
    }
    record.codes.insert(record.codes.end(), {0, 5,  0,  1,  2,  3, 4, // 12
                                             2, 3,  5,  6,  7,        // 13
                                             3, 2,  8,  9,            // 14
                                             1, 2,  10, 11,           // 15
                                             4, 12, 15,               // 16
                                             0, 4,  13, 14, 15, 16});
    return record;
}

TEST(Blobs, NearFieldsAreTheSameToTheLastBit) {
    const BlobField field = fieldOf(chain());
    std::mt19937 random(2);
    std::uniform_real_distribution<float> along(-1, 9), across(-1, 1.5f);
    for (int i = 0; i < 300; ++i) {
        const Vec3 low{along(random), across(random), across(random)};
        const Box3 box{low, low + Vec3{0.3f, 0.3f, 0.3f}};
        const BlobField near = field.within(box);
        for (Vec3 p : {box.low, box.high, box.centre()})
            EXPECT_EQ(near.at(p).value, field.at(p).value);
    }
    EXPECT_TRUE(isClosed(meshOf(field)));
}

TEST(Blobs, GradientsAreSlopes) {
    const BlobField field = fieldOf(chain());
    std::mt19937 random(5);
    std::uniform_real_distribution<float> along(-0.5f, 8), across(-0.5f, 0.8f);
    const float h = 1e-3f;
    for (int i = 0; i < 300; ++i) {
        const Vec3 p{along(random), across(random), across(random)};
        const Vec3 gradient = field.at(p).gradient;
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 low = p, high = p;
            low[axis] -= h, high[axis] += h;
            const float slope = (field.at(high).value - field.at(low).value) / (2 * h);
            EXPECT_NEAR(gradient[axis], slope, 0.02f * (1 + std::fabs(slope)));
        }
    }
}

TEST(Blobs, ValuesBlendAsFieldsDo) {
    const auto floats = together({placed(-0.4f, 0, 0, 1, 1, 1), placed(0.4f, 0, 0, 1, 1, 1)});
    const BlobbyRecord record{2, {1001, 0, 1001, 16, 0, 2, 0, 1}, floats, {}};
    const auto surface = surfaceOf(
        record, {parameter("Cs", StorageClass::Vertex, ValueType::Color, {1, 0, 0, 0, 0, 1}),
                 parameter("Kd", StorageClass::Constant, ValueType::Float, {0.7f})});
    ASSERT_TRUE(surface);
    int middles = 0;
    const std::uint32_t pieces = surface->domain().pieces;
    for (std::uint32_t piece = 0; piece < pieces; ++piece) {
        const float x = at(*surface, 1 / 3.0f, 1 / 3.0f, piece).P.x;
        const auto Cs = variable(*surface, "Cs", 1 / 3.0f, 1 / 3.0f, piece).value;
        EXPECT_NEAR(Cs[0] + Cs[2], 1, 1e-4);
        EXPECT_FLOAT_EQ(variable(*surface, "Kd", 0.2f, 0.2f, piece).value[0], 0.7f);
        if (std::fabs(x) < 0.05f) {
            EXPECT_NEAR(Cs[0], 0.5f, 0.2f);
            ++middles;
        }
        if (x > 0.65f) {
            EXPECT_GT(Cs[2], 0.95f);
        }
    }
    EXPECT_GT(middles, 0);
}

double volumeOf(const BlobMesh &mesh, Vec3 middle, float reach) {
    double volume = 0;
    for (const auto &t : mesh.triangles) {
        const auto at = [&](int k) { return mesh.positions[t[k]] - middle; };
        if (length(at(0)) < reach)
            volume += dot(at(0), cross(at(1), at(2))) / 6;
    }
    return volume;
}

/// Beside large blobs, and in combinations with them, small ones are what they are alone.
TEST(Blobs, SmallOnesKeepTheirVolumeBesideLargeOnes) {
    const double alone = 4 * std::numbers::pi / 3 / 8;
    for (float ratio : {1.0f, 7.0f, 20.0f, 50.0f})
        for (int code : {0, 2}) { // Added; the larger value.
            const Vec3 small{3 * ratio, 0.1f * ratio, 0}, large{0, 0, 0};
            const BlobMesh mesh = meshOf(fieldOf({2,
                                                  {1001, 0, 1001, 16, code, 2, 0, 1},
                                                  together({placed(0, 0, 0, ratio, ratio, ratio),
                                                            placed(small.x, small.y, 0, 1, 1, 1)}),
                                                  {}}));
            EXPECT_TRUE(isClosed(mesh));
            EXPECT_NEAR(volumeOf(mesh, small, 1) / alone, 1, ratio > 20 ? 0.03 : 0.008) << ratio;
            EXPECT_NEAR(volumeOf(mesh, large, ratio) / (alone * std::pow(ratio, 3)), 1, 0.008);
        }
}

TEST(Blobs, BoundsHoldWhateverTheFieldIs) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (int trial = 0; trial < 200; ++trial) {
        const auto number = [&] { return uniform(random); };
        std::vector<float> floats;
        for (int blob = 0; blob < 2; ++blob)
            for (float x : {1 + number() / 2, number(), number() / 2, 0.f, number() / 2,
                            1 + number() / 2, 0.f, 0.f, number() / 3, 0.f, 1 + number() / 2, 0.f,
                            number(), number(), number(), 1.f})
                floats.push_back(x);
        for (float x : {number(), number(), number(), number(), number(), number(), 0.7f})
            floats.push_back(x);
        for (float x : placed(number(), 0, 0, 1, 2, 1))
            floats.push_back(x);
        const int combine = trial % 6, operands = combine < 4 ? 2 : 0;
        std::vector<int> codes{1001, 0, 1001, 16, 1002, 32, combine};
        if (operands)
            codes.push_back(operands);
        codes.insert(codes.end(), {0, 1, 6, 3, 0, 2, 4, 2});
        const BlobField field = fieldOf({3, codes, floats, {}});
        const Vec3 low{number(), number(), number()};
        const float size = 0.02f + 0.5f * std::abs(number());
        const Box3 box{low, low + Vec3{size, size, size}};
        const FieldBounds whole = field.over(box), near = field.within(box).over(box);
        for (int k = 0; k < 200; ++k) {
            const auto inside = [&] { return size * (number() / 2 + 0.5f); };
            const float value = field.at(low + Vec3{inside(), inside(), inside()}).value;
            for (const FieldBounds &bounds : {whole, near}) {
                EXPECT_GE(value, bounds.low - 1e-4f * (1 + std::abs(value))) << trial;
                EXPECT_LE(value, bounds.high + 1e-4f * (1 + std::abs(value))) << trial;
            }
        }
    }
}

/// Long chains of codes and crowds of blobs take seconds of the processor.
TEST(Blobs, ManyAreSoonMeshed) {
    constexpr int n = 10000;
    BlobbyRecord chain, crowd;
    chain.leaves = crowd.leaves = n;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 60);
    for (int i = 0; i < n; ++i) {
        for (float x : placed(0.3f * float(i), std::sin(0.1f * float(i)), 0, 1, 1, 1))
            chain.floats.push_back(x);
        for (float x : placed(uniform(random), uniform(random), uniform(random), 2, 2, 2))
            crowd.floats.push_back(x);
        for (BlobbyRecord *each : {&chain, &crowd})
            each->codes.insert(each->codes.end(), {1001, 16 * i});
    }
    for (int i = 1; i < n; ++i)
        chain.codes.insert(chain.codes.end(), {0, 2, i == 1 ? 0 : n + i - 2, i});
    crowd.codes.insert(crowd.codes.end(), {0, n});
    for (int i = 0; i < n; ++i)
        crowd.codes.push_back(i);
    for (const BlobbyRecord *each : {&chain, &crowd}) {
        const std::clock_t start = std::clock();
        EXPECT_GT(meshOf(fieldOf(*each)).triangles.size(), 100000u);
        EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 20);
    }
    // Codes that all matter everywhere: the grid gets coarser.
    BlobbyRecord everywhere{1, {1001, 0}, placed(0, 0, 0, 1, 1, 1), {}};
    for (int i = 0; i < 2 * n; ++i)
        everywhere.codes.insert(everywhere.codes.end(), {2, 2, i, 0});
    const std::clock_t start = std::clock();
    const BlobMesh mesh = meshOf(fieldOf(everywhere));
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 20);
    EXPECT_NEAR(volumeOf(mesh, {}, 1), 4 * std::numbers::pi / 3 / 8, 0.1);
}

/// What the grid cannot hold is said, and not that there is nothing.
TEST(Blobs, ThatAreTooSmallBesideOthersAreToldOf) {
    const std::pair<std::vector<float>, bool> pairs[] = {
        {together({placed(3, 0, 0, 1, 1, 1), placed(0, 0, 0, 0.01f, 0.01f, 0.01f)}), true},
        {together({placed(0, 0, 0, 1, 1, 1), placed(0, 0, 0, 1, 1, 0.001f)}), true},
        {together({placed(1e7f, 0, 0, 1, 1, 1), placed(0, 0, 0, 1, 1, 1)}), true},
        {together({placed(3, 0, 0, 1, 1, 1), placed(0, 0, 0, 0.2f, 0.2f, 0.2f)}), false},
    };
    for (const auto &[floats, isTold] : pairs) {
        DiagnosticList diagnostics;
        makeSurfaces(record(BlobbyRecord{2, {1001, 0, 1001, 16, 0, 2, 0, 1}, floats, {}}), {},
                     diagnostics);
        EXPECT_EQ(diagnostics.text().find("come out coarse") != std::string::npos, isTold)
            << diagnostics.text();
        EXPECT_EQ(diagnostics.text().find("has no surface"), std::string::npos);
    }
}

TEST(Blobs, FieldsOfModulesAreLeftOut) {
    DiagnosticList diagnostics;
    const std::vector<float> floats = placed(0, 0, 0, 1, 1, 1);
    const auto surfaces =
        makeSurfaces(record(BlobbyRecord{2, {1001, 0, 9000, 2, 0, 16, 0, 2, 0, 1}, floats, {"m"}}),
                     {}, diagnostics);
    EXPECT_EQ(surfaces.size(), 1u);
    EXPECT_EQ(diagnostics.count(Severity::Error), 0) << diagnostics.text();
    EXPECT_NE(diagnostics.text().find("have no effect"), std::string::npos);
}

TEST(Blobs, ProgramsThatAreWrongAreDropped) {
    const std::pair<std::vector<int>, const char *> wrong[] = {
        {{}, "has no codes"},
        {{1001}, "ends within an instruction"},
        {{1001, 1}, "needs 16 floats from number 1 on, but has 16"},
        {{1001, -1}, "needs 16 floats"},
        {{1001, 0, 0, 2, 0, 1}, "combines field 1, which is not there yet"},
        {{1001, 0, 0, 2000000, 0}, "combines 2000000 fields"},
        {{1001, 0, 0, -1}, "combines -1 fields"},
        {{55, 0}, "has the unknown code 55 at place 0"},
        {{1004, 0, 1}, "ends within an instruction"},
        {{9000, 4, 0, 16, 1}, "ends within an instruction"},
        {{9000, -1}, "ends within an instruction"},
    };
    for (const auto &[codes, why] : wrong) {
        DiagnosticList diagnostics;
        const auto surfaces = makeSurfaces(
            record(BlobbyRecord{1, codes, placed(0, 0, 0, 1, 1, 1), {}}), {}, diagnostics);
        EXPECT_TRUE(surfaces.empty());
        EXPECT_NE(diagnostics.text().find(why), std::string::npos) << diagnostics.text();
    }
    DiagnosticList diagnostics;
    EXPECT_TRUE(
        makeSurfaces(record(BlobbyRecord{1, {1000, 0}, {0.1f}, {}}), {}, diagnostics).empty());
    EXPECT_NE(diagnostics.text().find("has no surface"), std::string::npos) << diagnostics.text();
}

} // namespace
} // namespace candela
