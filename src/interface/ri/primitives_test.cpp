// SPDX-License-Identifier: Apache-2.0
// Shapes and the counts of their variables (RI 3.2, section 5).
#include "interface/ri/graphics_state_fixture.h"
#include "interface/ri/variable_counts.h"

#include <cmath>

namespace candela::testing {

static VariableCounts meshCounts(bool bicubic, int u, int v, bool uPeriodic, bool vPeriodic,
                                 int uStep = 3, int vStep = 3) {
    Attributes attributes;
    attributes.uBasis.step = uStep;
    attributes.vBasis.step = vStep;
    ShapeRecord shape = PatchMeshRecord{bicubic, u, v, uPeriodic, vPeriodic};
    EXPECT_EQ(defectOf(shape, attributes), "");
    return countsOf(shape, attributes, 0);
}

TEST(VariableCounts, ofMeshesFollowTheTable) {
    struct {
        VariableCounts counts;
        int uniform, varying, vertex;
    } cases[] = {
        {meshCounts(false, 2, 2, false, false), 1, 4, 4},
        {meshCounts(false, 5, 4, false, false), 12, 20, 20},
        {meshCounts(false, 5, 4, true, false), 15, 20, 20},
        {meshCounts(false, 5, 4, true, true), 20, 20, 20},
        {meshCounts(true, 4, 4, false, false), 1, 4, 16},
        {meshCounts(true, 7, 4, false, false), 2, 6, 28},
        {meshCounts(true, 7, 5, false, false, 3, 1), 4, 9, 35},
        {meshCounts(true, 12, 4, true, false), 4, 8, 48},
        {meshCounts(true, 5, 5, true, true, 1, 1), 25, 25, 25},
    };
    for (const auto &each : cases) {
        EXPECT_EQ(each.counts.uniform, each.uniform);
        EXPECT_EQ(each.counts.varying, each.varying);
        EXPECT_EQ(each.counts.vertex, each.vertex);
    }
}

static SplineRecord spline(int vertices, int order) {
    SplineRecord result{vertices, order, {}, -100, 100};
    for (int i = 0; i < vertices + order; ++i)
        result.knots.push_back(float(i));
    return result;
}

TEST(VariableCounts, ofNurbsFollowTheirSegments) {
    const ShapeRecord shape = NuPatchRecord{spline(9, 3), spline(5, 4)};
    EXPECT_EQ(defectOf(shape, {}), "");
    EXPECT_EQ(verticesNeeded(shape, {}), 45);
    const VariableCounts counts = countsOf(shape, {}, 45);
    EXPECT_EQ(counts.uniform, 7 * 2);
    EXPECT_EQ(counts.varying, 8 * 3);
    EXPECT_EQ(counts.vertex, 45);
    EXPECT_EQ(counts.faceVarying, 4 * 7 * 2);
}

TEST(VariableCounts, defectsOfNurbsAreFound) {
    const auto with = [](auto change) {
        NuPatchRecord patch{spline(5, 3), spline(4, 2)};
        change(patch.u);
        return defectOf(patch, {});
    };
    EXPECT_EQ(with([](SplineRecord &) {}), "");
    EXPECT_NE(with([](SplineRecord &u) { u.knots.pop_back(); }), "");
    EXPECT_NE(with([](SplineRecord &u) { std::swap(u.knots[2], u.knots[3]); }), "");
    EXPECT_NE(with([](SplineRecord &u) { u.knots[4] = NAN; }), "");
    EXPECT_NE(with([](SplineRecord &u) { u.low = u.high; }), "");
    EXPECT_NE(with([](SplineRecord &u) { u.low = 6; }), "");
    EXPECT_NE(with([](SplineRecord &u) { u.high = NAN; }), "");
    EXPECT_NE(with([](SplineRecord &u) { u.knots.assign(8, 1.0f); }), "");
    EXPECT_NE(with([](SplineRecord &u) { u = spline(5, 1); }), "");
    EXPECT_NE(with([](SplineRecord &u) { u = spline(30, 25); }), "");
    EXPECT_NE(with([](SplineRecord &u) { u = spline(1, 2); }), "");
    EXPECT_NE(with([](SplineRecord &u) { u.vertices = -5; }), "");
}

TEST(VariableCounts, ofPolygonsFollowTheirIndices) {
    ShapeRecord shape = PolygonsRecord{{1, 2}, {3, 4, 3}, {0, 1, 2, 0, 1, 2, 3, 4, 5, 6}};
    EXPECT_EQ(defectOf(shape, {}), "");
    EXPECT_EQ(verticesNeeded(shape, {}), 7);
    VariableCounts counts = countsOf(shape, {}, 7);
    EXPECT_EQ(counts.uniform, 2);
    EXPECT_EQ(counts.vertex, 7);
    EXPECT_EQ(counts.faceVarying, 10);
}

static SubdivisionRecord subdivision(Integers counts, Integers vertices) {
    SubdivisionRecord mesh;
    mesh.vertexCounts = std::move(counts), mesh.vertices = std::move(vertices);
    return mesh;
}

TEST(VariableCounts, ofSubdivisionMeshesFollowTheirIndices) {
    const ShapeRecord shape = subdivision({4, 3}, {0, 1, 2, 3, 3, 2, 7});
    EXPECT_EQ(defectOf(shape, {}), "");
    EXPECT_EQ(verticesNeeded(shape, {}), 8);
    const VariableCounts counts = countsOf(shape, {}, 9);
    EXPECT_EQ(counts.uniform, 2);
    EXPECT_EQ(counts.varying, 9);
    EXPECT_EQ(counts.vertex, 9);
    EXPECT_EQ(counts.faceVarying, 7);
}

TEST(VariableCounts, defectsOfShapesAreFound) {
    const float infinite = INFINITY;
    ShapeRecord bad[] = {
        SphereRecord{0, -1, 1, 360},
        SphereRecord{1, 1, 2, 360},
        SphereRecord{1, -1, 1, 0},
        SphereRecord{infinite, -1, 1, 360},
        ConeRecord{1, 0, 360},
        CylinderRecord{1, 1, 1, 360},
        HyperboloidRecord{{1, 0, 0}, {1, 0, 0}, 360},
        HyperboloidRecord{{0, 0, 0}, {0, 0, 1}, 360},
        ParaboloidRecord{1, -1, 1, 360},
        ParaboloidRecord{1, 1, 1, 360},
        DiskRecord{0, 0, 360},
        TorusRecord{1, 0, 0, 360, 360},
        PolygonsRecord{{1}, {2}, {0, 1}},
        PolygonsRecord{{0}, {}, {}},
        PolygonsRecord{{}, {}, {}},
        PolygonsRecord{{2}, {3}, {0, 1, 2}},
        PolygonsRecord{{1}, {3}, {0, 1}},
        PolygonsRecord{{1}, {3}, {0, 1, -2}},
        PolygonsRecord{{1, 1}, {2147483647, 2147483647}, {0, 1, 2}},
        PatchMeshRecord{false, 1, 2, false, false},
        PatchMeshRecord{true, 5, 4, false, false},
        PatchMeshRecord{true, 4, 4, true, false},
        PatchMeshRecord{true, 3, 3, true, true},
        PatchMeshRecord{false, 1000000, 1000000, false, false},
        SubdivisionRecord{},
        subdivision({2}, {0, 1}),
        subdivision({3, 3}, {0, 1, 2}),
        subdivision({3}, {0, 1, -1}),
    };
    for (const ShapeRecord &shape : bad)
        EXPECT_NE(defectOf(shape, {}), "") << &shape - bad;
    ShapeRecord good[] = {SphereRecord{1, -1, 1, -90}, SphereRecord{1, -9, 9, 360},
                          ConeRecord{0, 1, 360},       ParaboloidRecord{1, 0, 1, 360},
                          DiskRecord{-1, 2, 90},       TorusRecord{0, 1, 0, 180, 360}};
    for (const ShapeRecord &shape : good)
        EXPECT_EQ(defectOf(shape, {}), "");
}

TEST_F(State, allShapesArrive) {
    state.worldBegin(at);
    state.sphere(at, 1, -1, 1, 360, {});
    state.cone(at, 1, 2, 360, {});
    state.cylinder(at, 1, 0, 1, 360, {});
    state.hyperboloid(at, 1, 0, 0, 1, 1, 1, 360, {});
    state.paraboloid(at, 1, 0, 1, 360, {});
    state.disk(at, 0, 1, 360, {});
    state.torus(at, 2, 1, 0, 360, 360, {});
    triangle();
    state.patchMesh(at, "bilinear", 2, "nowrap", 3, "periodic", numbers("P", Floats(18)));
    ASSERT_EQ(primitives().size(), 9u);
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_EQ(primitives()[i].record->shape.index(), i);
    EXPECT_EQ(errors(), 0);
    state.patch(at, "bicubic", numbers("P", Floats(48)));
    state.patch(at, "bilinear", numbers("Pw", Floats(16)));
    state.patch(at, "bilinear", numbers("Pz", Floats(4)));
    state.nuPatch(at, 3, 2, {0, 0, 1, 2, 2}, 0, 2, 2, 2, {0, 0, 1, 1}, 0, 1,
                  numbers("P", Floats(18)));
    TokenList fourCorners = numbers("P", Floats(18));
    fourCorners.all.push_back(numbers("s", {0, 1, 0, 1}).all.front());
    state.nuPatch(at, 3, 2, {0, 0, 1, 2, 2}, 0, 2, 2, 2, {0, 0, 1, 1}, 0, 1, fourCorners);
    EXPECT_NE(primitives().back().record->variables.find("s"), nullptr);
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(primitives().size(), 14u);
    // Two vertices make splines of order 2 at most.
    state.nuPatch(at, 2, 4, {0, 0, 0, 1, 1, 1}, 0, 1, 2, 2, {0, 0, 1, 1}, 0, 1,
                  numbers("Pw", Floats(16, 1)));
    ASSERT_EQ(primitives().size(), 15u);
    const auto &lowered = std::get<NuPatchRecord>(primitives().back().record->shape).u;
    EXPECT_EQ(lowered.order, 2);
    EXPECT_EQ(lowered.knots, (Floats{0, 0, 1, 1}));
    state.patch(at, "linear", numbers("P", Floats(48)));
    state.patchMesh(at, "bilinear", 2, "round", 3, "periodic", numbers("P", Floats(18)));
    EXPECT_EQ(errors(), 2);
}

TEST_F(State, tagsOfSubdivisionMeshesAreRead) {
    state.worldBegin(at);
    const Integers counts{4, 4, 3}, vertices{0, 1, 4, 3, 1, 2, 5, 4, 3, 4, 6};
    const auto points = numbers("P", Floats(21));
    const auto mesh = [&]() -> const SubdivisionRecord & {
        return std::get<SubdivisionRecord>(primitives().back().record->shape);
    };
    state.subdivisionMesh(at, "catmull-clark", counts, vertices, {}, points);
    ASSERT_EQ(primitives().size(), 1u);
    EXPECT_EQ(mesh().interpolateBoundary, 0);
    EXPECT_EQ(mesh().faceVaryingBoundary, 0);
    state.subdivisionMesh(at, "catmull-clark", counts, vertices,
                          {{"interpolateboundary", "hole", "crease", "corner", "crease",
                            "facevaryinginterpolateboundary"},
                           {0, 0, 1, 0, 3, 1, 2, 2, 3, 2, 1, 0},
                           {2, 0, 1, 4, 5, 6, 3, 4, 6, 2},
                           {2.5f, 1, 3, 4, 5}},
                          points);
    ASSERT_EQ(primitives().size(), 2u);
    EXPECT_EQ(mesh().interpolateBoundary, 1);
    EXPECT_EQ(mesh().faceVaryingBoundary, 2);
    EXPECT_EQ(mesh().holes, (Integers{2}));
    ASSERT_EQ(mesh().creases.size(), 4u);
    EXPECT_EQ(mesh().creases[1].vertices, (Integers{1, 4}));
    EXPECT_EQ(mesh().creases[1].sharpness, 2.5f);
    EXPECT_EQ(mesh().creases[3].vertices, (Integers{4, 6}));
    EXPECT_EQ(mesh().creases[3].sharpness, 5);
    ASSERT_EQ(mesh().corners.size(), 2u);
    EXPECT_EQ(mesh().corners[1].vertex, 6);
    EXPECT_EQ(mesh().corners[1].sharpness, 3);
    // As later files have them: integers, floats and strings are counted.
    state.subdivisionMesh(at, "catmull-clark", counts, vertices,
                          {{"interpolateboundary", "hole"}, {1, 0, 0, 1, 0, 0}, {2, 1}, {}},
                          points);
    EXPECT_EQ(mesh().interpolateBoundary, 2);
    EXPECT_EQ(mesh().holes, (Integers{1}));
    EXPECT_EQ(errors(), 0);
}

TEST_F(State, badTagsAreLeftOutAndTheMeshIsKept) {
    state.worldBegin(at);
    const auto with = [&](SubdivisionTags tags) {
        state.subdivisionMesh(at, "catmull-clark", {3}, {0, 1, 2}, tags, numbers("P", Floats(9)));
    };
    const SubdivisionTags bad[] = {
        {{"hole"}, {1, 0}, {1}, {}},
        {{"hole"}, {1, 0}, {}, {}},
        {{"hole"}, {1}, {0}, {}},
        {{"hole"}, {-1, 0}, {0}, {}},
        {{"crease"}, {1, 1}, {0}, {1}},
        {{"crease"}, {2, 0}, {0, 1}, {}},
        {{"crease"}, {2, 1}, {0, 9}, {1}},
        {{"crease"}, {2, 1}, {0, 1}, {-1}},
        {{"crease"}, {2, 1}, {0, 1}, {NAN}},
        {{"corner"}, {3, 2}, {0, 1, 2}, {1, 2}},
        {{"interpolateboundary"}, {1, 0}, {7}, {}},
    };
    int count = 0;
    for (const SubdivisionTags &tags : bad) {
        with(tags);
        ++count;
        EXPECT_EQ(errors(), count);
        EXPECT_EQ(int(primitives().size()), count);
    }
    with({{"smoothtriangles"}, {1, 0}, {0}, {}}); // Of others: a warning.
    EXPECT_EQ(errors(), count);
    EXPECT_EQ(int(primitives().size()), count + 1);
    // Edits of finer levels, all in one warning.
    const int told = warnings();
    state.hierarchicalSubdivisionMesh(
        at, "loop", {3}, {0, 1, 2}, {"vertexedit", "faceedit", "edgeedit"},
        {1, 0, 0, 1, 1, 1, 1, 0, 0}, {0, 0, 1}, {.5f}, {"edit"}, numbers("P", Floats(9)));
    EXPECT_EQ(warnings(), told + 1);
    EXPECT_EQ(errors(), count);
    EXPECT_EQ(std::get<SubdivisionRecord>(primitives().back().record->shape).scheme,
              SubdivisionRecord::Scheme::Loop);
}

TEST_F(State, geometryIsKnownByName) {
    state.worldBegin(at);
    state.geometry(at, "teapot", {});
    EXPECT_EQ(primitives().size(), 1u);
    state.geometry(at, "bunny", {});
    EXPECT_EQ(primitives().size(), 1u);
    EXPECT_EQ(errors(), 0);
}

TEST_F(State, polygonsAreOneRecord) {
    state.worldBegin(at);
    auto shape = [&]() -> const PolygonsRecord & {
        return std::get<PolygonsRecord>(primitives().back().record->shape);
    };
    triangle();
    EXPECT_EQ(shape().vertices, (Integers{0, 1, 2}));
    state.generalPolygon(at, {4, 3}, numbers("P", Floats(21)));
    EXPECT_EQ(shape().loopCounts, (Integers{2}));
    EXPECT_EQ(shape().vertices.size(), 7u);
    state.pointsPolygons(at, {3, 3}, {0, 1, 2, 2, 1, 3}, numbers("P", Floats(12)));
    EXPECT_EQ(shape().loopCounts, (Integers{1, 1}));
    state.pointsGeneralPolygons(at, {2}, {3, 3}, {0, 1, 2, 2, 1, 3}, numbers("P", Floats(15)));
    EXPECT_EQ(shape().loopCounts, (Integers{2}));
    EXPECT_EQ(errors(), 0); // Also where P has points that no polygon uses.
    EXPECT_EQ(primitives().size(), 4u);
}

TEST_F(State, primitivesWithoutGoodPointsAreLeftOut) {
    state.worldBegin(at);
    state.polygon(at, {});
    triangle({0, 0, 0, 1, 0, 0});
    triangle({0, 0, 0, 1, 0, 0, 0, 1});
    triangle({0, 0, 0, 1, 0, 0, 0, NAN, 0});
    triangle({0, 0, 0, 1, 0, 0, 0, INFINITY, 0});
    state.pointsPolygons(at, {3}, {0, 1, 3}, numbers("P", Floats(9)));
    state.patch(at, "bilinear", numbers("P", Floats(15)));
    state.patch(at, "bilinear", numbers("N", Floats(12)));
    state.polygon(at, text("P", "here"));
    EXPECT_EQ(errors(), 10); // The last says twice what is wrong with it.
    EXPECT_TRUE(primitives().empty());
    triangle();
    EXPECT_EQ(primitives().size(), 1u);
}

TEST_F(State, badVariablesAreLeftOutAndThePrimitiveStays) {
    state.worldBegin(at);
    sphere(numbers("Cs", {1, 0, 0, 1}));
    sphere(numbers("constant color Cs", {1, 0, NAN}));
    sphere(text("Cs", "red"));
    EXPECT_EQ(errors(), 3);
    sphere(numbers("mystery", {1}));
    EXPECT_EQ(errors(), 3);
    EXPECT_EQ(warnings(), 1);
    ASSERT_EQ(primitives().size(), 4u);
    for (const auto &primitive : primitives())
        EXPECT_TRUE(primitive.record->variables.all.empty());
    EXPECT_TRUE(says("'Cs' (varying color) needs 12 numbers here, found 4"));
    sphere(numbers("Cs", Floats(12)));
    sphere(numbers("constant color Cs", {1, 0, 0}));
    sphere(numbers("facevarying float[2] st", Floats(8)));
    sphere(numbers("uniform normal Np", Floats(3)));
    EXPECT_EQ(errors(), 3);
    EXPECT_EQ(primitives()[7].record->variables.all.size(), 1u);
}

TEST_F(State, degenerateQuadricsAreReported) {
    state.worldBegin(at);
    state.sphere(at, 0, 0, 0, 360, {});
    EXPECT_TRUE(says("Sphere: it is degenerate"));
    EXPECT_TRUE(primitives().empty());
}

TEST_F(State, basesAreKnownByNameOrMatrix) {
    state.worldBegin(at);
    for (const char *name :
         {"bezier", "b-spline", "catmull-rom", "hermite", "power", "bspline", "catmullrom"}) {
        state.basis(at, std::string(name), 1, std::string("bezier"), 3);
        sphere();
        // Whatever the basis, a curve through equal points stays there: except for the bases
        // that take tangents or coefficients, the weights at each parameter sum to one.
        const auto &m = last().uBasis.matrix;
        bool points = std::string(name) != "hermite" && std::string(name) != "power";
        for (int row = 0; row < 4 && points; ++row)
            EXPECT_NEAR(m[row * 4] + m[row * 4 + 1] + m[row * 4 + 2] + m[row * 4 + 3],
                        row == 3 ? 1 : 0, 1e-6)
                << name;
        EXPECT_EQ(last().uBasis.step, 1);
        EXPECT_EQ(last().vBasis.step, 3);
    }
    std::array<float, 16> own{};
    own[5] = 2;
    state.basis(at, own, 2, own, 2);
    sphere();
    EXPECT_EQ(last().vBasis.matrix[5], 2);
    state.basis(at, std::string("nurbs"), 1, std::string("bezier"), 3);
    state.basis(at, std::string("bezier"), 0, std::string("bezier"), 3);
    EXPECT_EQ(errors(), 2);
}

TEST_F(State, indicesBeyondThePointsAreNamed) {
    state.worldBegin(at);
    state.pointsPolygons(at, {3}, {0, 7, 2}, numbers("P", {0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_TRUE(says("there is no vertex 7: \"P\" holds 3 points"));
    state.pointsPolygons(at, {3}, {0, 2147483647, 2}, numbers("P", {0, 0, 0, 1, 0, 0, 0, 1, 0}));
    EXPECT_TRUE(says("there is no vertex 2147483647"));
    EXPECT_TRUE(primitives().empty());
}

TEST_F(State, aBadFaceCostsThatFaceAlone) {
    state.worldBegin(at);
    const Floats square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const struct {
        Integers loops, counts, vertices;
        Floats points;
        const char *says;
    } table[] = {
        {{1, 1, 1}, {3, 4, 3}, {0, 1, 2, 0, 1, 2, 99, 0, 2, 3}, square, "face 1 has the vertex 99"},
        {{1, 1, 1}, {3, 4, 3}, {0, 1, 2, 0, 1, -2, 3, 0, 2, 3}, square, "face 1 has the negative"},
        {{1, 1, 1}, {3, 2, 3}, {0, 1, 2, 0, 1, 0, 2, 3}, square, "face 1 has fewer than three"},
        {{1, 1, 1}, {3, 0, 3}, {0, 1, 2, 0, 2, 3}, square, "face 1 has fewer than three"},
        {{1, 2, 1}, {3, 4, 2, 3}, {0, 1, 2, 0, 1, 2, 3, 0, 1, 0, 2, 3}, square, "face 1 has fewer"},
        {{1, 1, 1},
         {3, 3, 3},
         {0, 1, 2, 0, 1, 4, 0, 2, 3},
         {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, NAN, 0},
         "face 1 has the vertex 4, which is not"},
    };
    for (const auto &[loops, counts, vertices, points, words] : table) {
        const std::size_t before = primitives().size();
        TokenList variables = numbers("P", points);
        variables.all.push_back(numbers("uniform float number", {0, 1, 2}).all[0]);
        Floats corners;
        for (std::size_t i = 0; i < vertices.size(); ++i)
            corners.push_back(float(i));
        variables.all.push_back(numbers("facevarying float corner", corners).all[0]);
        state.pointsGeneralPolygons(at, loops, counts, vertices, variables);
        EXPECT_TRUE(says(words)) << words;
        ASSERT_EQ(primitives().size(), before + 1) << words;
        const PrimitiveRecord &record = *primitives().back().record;
        EXPECT_EQ(std::get<PolygonsRecord>(record.shape).vertices, (Integers{0, 1, 2, 0, 2, 3}));
        EXPECT_EQ(record.variables.find("number")->floats, (Floats{0, 2})) << words;
        const float last = float(vertices.size());
        EXPECT_EQ(record.variables.find("corner")->floats,
                  (Floats{0, 1, 2, last - 3, last - 2, last - 1}))
            << words;
    }
    EXPECT_EQ(errors(), int(std::size(table)));
    // Points that no face uses do no harm.
    state.pointsPolygons(at, {3}, {0, 1, 2}, numbers("P", {0, 0, 0, 1, 0, 0, 0, 1, 0, NAN, 0, 0}));
    EXPECT_EQ(errors(), int(std::size(table)));
    EXPECT_EQ(primitives().size(), std::size(table) + 1);
}

TEST_F(State, widthsOfTheWrongNumberAreFitted) {
    struct {
        const char *token;
        Floats given, kept;
    } const cases[] = {
        {"varying float width", {.1f, .2f}, {.1f, .2f}},
        {"varying float width", {.1f, .2f, .3f}, {.1f, .2f}},
        {"varying float width", {.1f}, {.1f, .1f}},
        {"constantwidth", {.1f, .2f}, {.1f}},
    };
    state.worldBegin(at);
    int told = 0;
    for (const auto &each : cases) {
        TokenList tokens = numbers("P", {0, 0, 0, 1, 0, 0});
        tokens.all.push_back({each.token, {}, each.given, {}});
        state.points(at, tokens);
        told += each.given != each.kept;
        EXPECT_EQ(primitives().back().record->variables.all.back().floats, each.kept) << each.token;
        EXPECT_EQ(warnings(), told);
    }
    EXPECT_EQ(errors(), 0);
}

} // namespace candela::testing
