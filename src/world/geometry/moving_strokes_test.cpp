// SPDX-License-Identifier: Apache-2.0
// Curves and points that change their shape while the shutter is open are at each moment what
// their values are then.
#include "world/geometry/test_support.h"

#include <cmath>

namespace candela {
namespace {

using namespace geometrytest;

struct Case {
    const char *name;
    ShapeRecord shape;
    StorageClass widths;
    bool isRibbon = false, isOfLines = false;
};

void PrintTo(const Case &c, std::ostream *stream) { *stream << c.name; }

const Case cases[] = {
    {"tubes", CurvesRecord{true, false, {4, 7}}, StorageClass::Varying},
    {"tubes that close", CurvesRecord{true, true, {6, 6}}, StorageClass::Vertex},
    {"one line", CurvesRecord{false, false, {2}}, StorageClass::Constant},
    {"lines", CurvesRecord{false, false, {4}}, StorageClass::Varying, false, true},
    {"ribbons", CurvesRecord{true, false, {4, 7}}, StorageClass::Varying, true},
    {"points", PointsRecord{5}, StorageClass::Vertex},
};

int verticesOf(const Case &c) {
    if (const auto *points = std::get_if<PointsRecord>(&c.shape))
        return points->count;
    int sum = 0;
    for (int count : std::get<CurvesRecord>(c.shape).vertexCounts)
        sum += count;
    return sum;
}

/// How many values a class has that is not of vertices.
int endsOf(const Case &c) {
    const auto &curves = std::get<CurvesRecord>(c.shape);
    int ends = 0;
    for (int count : curves.vertexCounts)
        ends += curveSegments(curves, count, 3) + (curves.periodic ? 0 : 1);
    return ends;
}

std::shared_ptr<PrimitiveRecord> at(const Case &c, double time) {
    const auto t = float(time);
    const int vertices = verticesOf(c);
    std::vector<float> P, N, widths, colors;
    for (int i = 0; i < vertices; ++i) {
        const auto x = float(i);
        P.insert(P.end(), {x + .2f * t, std::sin(x) + .3f * t * x, .5f * std::cos(2 * x) - t});
        N.insert(N.end(), {.3f * t, .1f * x, 1});
        colors.insert(colors.end(), {t, .1f * x, 1 - t});
    }
    const int widthCount = c.widths == StorageClass::Constant ? 1
                           : c.widths == StorageClass::Vertex ? vertices
                                                              : endsOf(c);
    for (int i = 0; i < widthCount; ++i)
        widths.push_back(.1f + .05f * float(i) + .1f * t);
    std::vector<Parameter> variables{
        parameter("P", StorageClass::Vertex, ValueType::Point, P),
        parameter("width", c.widths, ValueType::Float, widths),
        parameter("Cs", StorageClass::Vertex, ValueType::Color, colors)};
    if (c.isRibbon)
        variables.push_back(parameter("N", StorageClass::Vertex, ValueType::Normal, N));
    return record(c.shape, variables);
}

std::shared_ptr<const Surface> stillAt(const Case &c, double time) {
    DiagnosticList said;
    const auto surfaces = makeSurfaces(at(c, time), {}, said);
    EXPECT_EQ(said.text(), "");
    return surfaces.at(0);
}

/// It goes on to what it is at time 1, by three knots.
std::shared_ptr<PrimitiveRecord> inMotion(const Case &c) {
    auto moving = at(c, 0);
    auto motion = std::make_shared<InTime<std::shared_ptr<const PrimitiveRecord>>>();
    for (double time : {0., .25, 1.}) {
        motion->times.push_back(time);
        motion->values.push_back(at(c, time));
    }
    moving->motion = motion;
    return moving;
}

std::shared_ptr<const Surface> movingOf(const Case &c, const Shutter &shutter) {
    DiagnosticList said;
    const auto surfaces = makeSurfaces(inMotion(c), {}, shutter, said);
    EXPECT_EQ(said.text(), "");
    return surfaces.at(0);
}

Vec3 placeOn(const Surface &surface, std::uint32_t piece, float u, float v, float share) {
    Vec3 P;
    SurfaceAnswer answer;
    answer.P = {&P.x, &P.y, &P.z};
    surface.evaluate({1, &piece, &u, &v, &share}, answer);
    return P;
}

class MovingStroke : public testing::TestWithParam<Case> {};

TEST_P(MovingStroke, IsAtEachMomentWhatItsValuesAre) {
    const Case &c = GetParam();
    const auto moving = movingOf(c, {0, 1});
    ASSERT_GE(moving->steps(), 5); // One at each quarter.
    for (float share : {0.f, .1f, .25f, .6f, 1.f}) {
        const auto still = stillAt(c, share);
        ASSERT_EQ(moving->domain().pieces, still->domain().pieces);
        // The mitres of lines go straight between the steps, which those of stills do not.
        const float tolerance = c.isOfLines ? 2e-3f : 1e-5f;
        for (std::uint32_t piece = 0; piece < still->domain().pieces; ++piece)
            for (float u : {.1f, .8f})
                for (float v : {0.f, .3f, .9f}) {
                    SCOPED_TRACE(std::to_string(share) + " " + std::to_string(piece));
                    const Vec3 P = placeOn(*moving, piece, u, v, share);
                    EXPECT_LT(length(P - placeOn(*still, piece, u, v, 0)), tolerance);
                    const Box3 bound = moving->bound();
                    for (int k = 0; k < 3; ++k)
                        EXPECT_TRUE(P[k] >= bound.low[k] && P[k] <= bound.high[k]);
                }
    }
}

TEST_P(MovingStroke, TellsVariablesInTime) {
    const auto moving = movingOf(GetParam(), {0, 1});
    const int Cs = numberOf(*moving, "Cs");
    for (float share : {0.f, .1f, .6f, 1.f}) {
        float r = 0, g = 0, b = 0, u = .5f, v = .5f;
        float *const value[] = {&r, &g, &b};
        std::uint32_t piece = 0;
        moving->evaluateVariable(Cs, {1, &piece, &u, &v, &share}, value, nullptr, nullptr);
        EXPECT_NEAR(r, share, 1e-6f);
        EXPECT_NEAR(b, 1 - share, 1e-6f);
    }
}

TEST_P(MovingStroke, HasStepsThatStandStill) {
    const auto moving = movingOf(GetParam(), {0, 1});
    for (int step = 0; step < moving->steps(); ++step) {
        const auto still = moving->step(step);
        const float share = float(step) / float(moving->steps() - 1);
        EXPECT_EQ(still->steps(), 1);
        EXPECT_LT(length(placeOn(*still, 0, .3f, .4f, 0) - placeOn(*moving, 0, .3f, .4f, share)),
                  1e-5f);
    }
}

/// What rays meet at a moment has the names that it has there.
TEST_P(MovingStroke, IsNamedAtTheMoment) {
    const Case &c = GetParam();
    const auto moving = movingOf(c, {.1, .9});
    if (!moving->isRound())
        return;
    const RoundElements round = moving->roundElements();
    for (const auto &knots : round.later)
        EXPECT_EQ(knots.size(), round.knots.size());
    const auto splits = std::uint32_t(round.size() / moving->domain().pieces);
    for (float share : {0.f, .3f, .7f, 1.f})
        for (std::uint32_t number = 0; number < moving->domain().pieces; ++number)
            for (float v : {.02f, .4f, .93f}) {
                Vec3 P = placeOn(*moving, number, .3f, v, share);
                const float place = v * float(splits);
                std::uint32_t piece = number * splits + std::uint32_t(place);
                float u = place - std::floor(place), found = -1;
                moving->nameRound(1, {&P.x, &P.y, &P.z}, &share, &piece, &u, &found);
                EXPECT_EQ(piece, number);
                EXPECT_LT(length(placeOn(*moving, piece, u, found, share) - P), 1e-5f);
            }
}

INSTANTIATE_TEST_SUITE_P(, MovingStroke, testing::ValuesIn(cases), [](const auto &param) {
    std::string name = param.param.name;
    std::erase(name, ' ');
    return name;
});

/// Values that cannot be taken at one of the times leave the shape as it is when the shutter opens.
TEST(MovingStrokes, KeepTheirShapeWhereItComesToNothing) {
    const Case &points = cases[5];
    struct Fault {
        const char *name;
        std::function<void(PrimitiveRecord &)> make;
    };
    const Fault faults[] = {
        {"P", [](PrimitiveRecord &r) { r.variables.all[0].floats[1] = NAN; }},
        {"no width", [](PrimitiveRecord &r) { r.variables.all[1].floats.assign(5, 0); }},
        {"color", [](PrimitiveRecord &r) { r.variables.all[2].floats[4] = INFINITY; }},
    };
    for (const Fault &fault : faults) {
        SCOPED_TRACE(fault.name);
        auto moving = at(points, 0);
        auto last = at(points, 1);
        fault.make(*last);
        auto motion = std::make_shared<InTime<std::shared_ptr<const PrimitiveRecord>>>();
        motion->times = {0, 1};
        motion->values = {at(points, 0), last};
        moving->motion = motion;
        DiagnosticList said;
        const auto surfaces = makeSurfaces(moving, {}, {0, 1}, said);
        ASSERT_EQ(surfaces.size(), 1u);
        EXPECT_EQ(surfaces[0]->steps(), 1);
        EXPECT_NE(said.text().find("keeps its shape"), std::string::npos) << said.text();
    }
}

} // namespace
} // namespace candela
