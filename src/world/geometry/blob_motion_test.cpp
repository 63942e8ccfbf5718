// SPDX-License-Identifier: Apache-2.0
// Meshes of blobs that move, against closed forms and against the field that they are to be of.
#include "world/geometry/blob_motion.h"
#include "world/geometry/test_support.h"

#include <cmath>

namespace candela {
namespace {

using namespace geometrytest;

BlobField fieldOf(const BlobbyRecord &record) {
    DiagnosticList diagnostics;
    auto field = BlobField::make(record, {}, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    return field.value_or(BlobField{});
}

/// A turn about z, a stretch and a way.
Matrix4 placed(float degrees, Vec3 stretch, Vec3 way) {
    const float angle = degrees * std::numbers::pi_v<float> / 180;
    Matrix4 m;
    m.m = {std::cos(angle),
           std::sin(angle),
           0,
           0,
           -std::sin(angle),
           std::cos(angle),
           0,
           0,
           0,
           0,
           1,
           0,
           way.x,
           way.y,
           way.z,
           1};
    Matrix4 scale;
    for (int k = 0; k < 3; ++k)
        scale.m[std::size_t(5 * k)] = stretch[k];
    return scale * m;
}

/// An ellipsoid and a segment that it runs into, all in another place.
BlobbyRecord pairAt(const Matrix4 &place) {
    BlobbyRecord record{2, {1001, 0, 1002, 16, 0, 2, 0, 1}, {}, {}};
    const Matrix4 round = placed(30, {1, .8f, .6f}, {0, 0, 0}) * place;
    record.floats.assign(round.m.begin(), round.m.end());
    record.floats.insert(record.floats.end(), {.2f, 0, 0, .9f, .4f, 0, .5f});
    record.floats.insert(record.floats.end(), place.m.begin(), place.m.end());
    return record;
}

float largestOffset(const BlobField &field, const BlobMesh &mesh) {
    float largest = 0;
    for (Vec3 p : mesh.positions)
        largest = std::max(largest, std::fabs(field.at(p).value - blobThreshold));
    return largest;
}

TEST(BlobMotion, WhatMovesAsOneKeepsItsShape) {
    const BlobField from = fieldOf(pairAt({}));
    const BlobMesh mesh = meshOf(from);
    struct Case {
        const char *name;
        Matrix4 place;
        float size = 1;
    };
    const Case cases[] = {
        {"nowhere", {}},
        {"along", placed(0, {1, 1, 1}, {5, -3, 2})},
        {"around", placed(70, {1, 1, 1}, {0, 0, 0})},
        {"half a turn", placed(180, {1, 1, 1}, {1, 0, 0})},
        {"larger", placed(0, {3, 3, 3}, {0, 0, 0}), 3},
        {"tiny", placed(20, {1e-3f, 1e-3f, 1e-3f}, {0, 0, 0}), 1e-3f},
        {"in a mirror", placed(0, {-1, 1, 1}, {0, 0, 0})},
        {"squeezed", placed(10, {1, .5f, 2}, {1, 2, 3}), 2},
    };
    for (const Case &c : cases) {
        SCOPED_TRACE(c.name);
        const auto carried = carriedTo(fieldOf(pairAt(c.place)), from, mesh);
        ASSERT_TRUE(carried);
        ASSERT_EQ(carried->positions.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); i += 7)
            EXPECT_LT(length(carried->positions[i] - transformPoint(c.place, mesh.positions[i])),
                      2e-3f * c.size);
    }
}

/// Each blob goes its own way, and the surface with them.
TEST(BlobMotion, VerticesLieOnWhatBlobsHaveBecome) {
    const BlobField from = fieldOf(pairAt({}));
    const BlobMesh mesh = meshOf(from);
    BlobbyRecord later = pairAt({});
    later.floats[12] += .3f, later.floats[13] -= .2f; // The ellipsoid goes,
    later.floats[0] *= 1.3f;                          // widens,
    later.floats[19] += .5f, later.floats[22] = .4f;  // and the segment stretches and thins.
    const BlobField to = fieldOf(later);
    const auto carried = carriedTo(to, from, mesh);
    ASSERT_TRUE(carried);
    EXPECT_LT(largestOffset(to, *carried), 2e-4f);
    const double area = areaOf({carried->positions, carried->triangles, {}, {}, 0});
    const BlobMesh anew = meshOf(to);
    EXPECT_NEAR(area / areaOf({anew.positions, anew.triangles, {}, {}, 0}), 1, .01);
    for (std::size_t i = 0; i < carried->positions.size(); i += 5) {
        const Vec3 slope = to.at(carried->positions[i]).gradient;
        EXPECT_LT(length(carried->normals[i] + normalize(slope)), 1e-3f);
    }
}

TEST(BlobMotion, WhatPartsIsNotCarried) {
    const BlobField from = fieldOf(pairAt({}));
    const BlobMesh mesh = meshOf(from);
    BlobbyRecord later = pairAt({});
    later.floats[12] -= 9;
    EXPECT_FALSE(carriedTo(fieldOf(later), from, mesh));
    BlobbyRecord gone = pairAt({});
    gone.codes = {1000, 0, 1000, 0, 0, 2, 0, 1};
    EXPECT_FALSE(carriedTo(fieldOf(gone), from, mesh));
}

/// A ball that goes and grows, as primitives tell it.
std::shared_ptr<PrimitiveRecord> ballAt(float t) {
    BlobbyRecord blobby{1, {1001, 0}, {}, {}};
    const float r = 2 + t;
    blobby.floats = {r, 0, 0, 0, 0, r, 0, 0, 0, 0, r, 0, 4 * t, 0, 0, 1};
    return record(blobby, {parameter("Cs", StorageClass::Vertex, ValueType::Color, {t, 0, 1 - t})});
}

std::vector<std::shared_ptr<const Surface>> moving(std::shared_ptr<PrimitiveRecord> last,
                                                   DiagnosticList &said) {
    auto first = ballAt(0);
    auto motion = std::make_shared<InTime<std::shared_ptr<const PrimitiveRecord>>>();
    motion->times = {0, 1};
    motion->values = {ballAt(0), std::move(last)};
    first->motion = motion;
    return makeSurfaces(first, {}, {0, 1}, said);
}

TEST(BlobMotion, ABallIsABallAtEachMoment) {
    DiagnosticList said;
    const auto surfaces = moving(ballAt(1), said);
    EXPECT_EQ(said.text(), "");
    ASSERT_EQ(surfaces.size(), 1u);
    ASSERT_EQ(surfaces[0]->steps(), 2);
    for (float share : {0.f, .5f, 1.f})
        for (std::uint32_t piece = 0; piece < surfaces[0]->domain().pieces; piece += 97) {
            Vec3 P, N;
            float u = 0, v = 0, Cs[3];
            SurfaceAnswer answer;
            answer.P = {&P.x, &P.y, &P.z}, answer.N = {&N.x, &N.y, &N.z};
            surfaces[0]->evaluate({1, &piece, &u, &v, &share}, answer);
            const Vec3 out = P - Vec3{4 * share, 0, 0};
            EXPECT_NEAR(length(out), 1 + share / 2, 2e-3f);
            EXPECT_LT(length(normalize(N) - normalize(out)), 5e-3f);
            float *const value[] = {Cs, Cs + 1, Cs + 2};
            surfaces[0]->evaluateVariable(numberOf(*surfaces[0], "Cs"), {1, &piece, &u, &v, &share},
                                          value, nullptr, nullptr);
            EXPECT_NEAR(Cs[0], share, 1e-5f);
        }
}

TEST(BlobMotion, WhatComesToNothingKeepsItsShape) {
    const auto withFloat = [](std::size_t place, float value) {
        auto last = ballAt(1);
        std::get<BlobbyRecord>(last->shape).floats[place] = value;
        return last;
    };
    auto withColor = ballAt(1);
    withColor->variables.all[0].floats[1] = NAN;
    for (const auto &last : {withFloat(0, 0), withFloat(0, NAN), withFloat(12, 1e30f), withColor}) {
        DiagnosticList said;
        const auto surfaces = moving(last, said);
        ASSERT_EQ(surfaces.size(), 1u);
        EXPECT_EQ(surfaces[0]->steps(), 1);
        EXPECT_NE(said.text().find("keeps its shape"), std::string::npos) << said.text();
    }
}

} // namespace
} // namespace candela
