// SPDX-License-Identifier: Apache-2.0
// Where light shaders send light, as Question::Emission says.
#include "language/ir/core/regions.h"
#include "language/ir/lower/test_support.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"

#include <numbers>

namespace candela::ir {
namespace {

constexpr float unreached = -123;

/// One cone as a lane sees it.
struct StatedCone {
    Vec3 position, axis;
    float angle, exponent, importance;
};

class LowerEmission : public testing::Test {
protected:
    void lower(const std::string &body, const std::string &before = "") {
        run_.emplace(before +
                     "light test(point from = point \"shader\" (1, 2, 3);"
                     "           float half = .5; float turns = 3;) { " +
                     body + " }");
        ASSERT_TRUE(run_->lowered) << run_->diagnostics.text();
        run_->setParameter("from", {1, 2, 3});
        facts_ = lightFacts(whole());
        const Function emission = slice(whole(), Question::Emission);
        ASSERT_EQ(verify(emission), "") << print(emission);
        planes_ = run_->batch->run(emission, interpret, unreached);
    }
    const Function &whole() const { return run_->lowered->whole; }

    StatedCone cone(int n, int lane = 0) const {
        const ConeSlot &slot = facts_.cones.at(size_t(n));
        const auto at = [&](int plane) { return planes_[size_t(plane)][size_t(lane)]; };
        const auto triple = [&](int plane) {
            return Vec3{at(plane), at(plane + 1), at(plane + 2)};
        };
        return {triple(slot.position), triple(slot.axis), at(slot.angle), at(slot.exponent),
                at(slot.importance)};
    }

    static void expectNear(Vec3 a, Vec3 b) {
        EXPECT_NEAR(a.x, b.x, 1e-5);
        EXPECT_NEAR(a.y, b.y, 1e-5);
        EXPECT_NEAR(a.z, b.z, 1e-5);
    }

    std::optional<ShaderRun> run_;
    LightFacts facts_;
    std::vector<ShaderRun::Plane> planes_;
};

TEST_F(LowerEmission, AmbientLightSendsNone) {
    lower("Cl = 1;");
    EXPECT_TRUE(facts_.cones.empty());
}

TEST_F(LowerEmission, PointLightSendsEverywhere) {
    lower("illuminate(from) Cl = 1 / (L . L);");
    ASSERT_EQ(facts_.cones.size(), 1u);
    EXPECT_FALSE(whole().emissions[0].distant);
    expectNear(cone(0).position, {1, 2, 3});
    EXPECT_EQ(cone(0).angle, 360);
    EXPECT_EQ(cone(0).exponent, 0);
    EXPECT_EQ(cone(0).importance, 1);
    EXPECT_TRUE(facts_.conesAreTheLights);
}

TEST_F(LowerEmission, ClassicConeHasTwiceItsHalfAngle) {
    lower("illuminate(from, vector(0, 0, 5), radians(20)) Cl = 1;");
    expectNear(cone(0).axis, {0, 0, 1});
    EXPECT_NEAR(cone(0).angle, 40, 1e-4);
    lower("illuminate(from, vector(0, 0, 5), 7) Cl = 1;");
    EXPECT_EQ(cone(0).angle, 360);
}

TEST_F(LowerEmission, ExtendedConesAsTheTextHasThem) {
    lower("illuminate(P, 2, N, 180, 1, .25, -N, 30, 20, color(1, 1, 1)) Cl = 1;");
    ASSERT_EQ(facts_.cones.size(), 2u);
    for (int lane : {0, 7}) {
        const Vec3 P{float(run_->input(ShaderInput::P, lane, 0)),
                     float(run_->input(ShaderInput::P, lane, 1)),
                     float(run_->input(ShaderInput::P, lane, 2))};
        const Vec3 N{float(run_->input(ShaderInput::N, lane, 0)),
                     float(run_->input(ShaderInput::N, lane, 1)),
                     float(run_->input(ShaderInput::N, lane, 2))};
        expectNear(cone(0, lane).position, P);
        expectNear(cone(0, lane).axis, N);
        expectNear(cone(1, lane).axis, N * -1);
        EXPECT_EQ(cone(0, lane).importance, .25f);
        EXPECT_NEAR(cone(1, lane).importance, 1, 1e-6);
        EXPECT_EQ(cone(1, lane).angle, 30);
        EXPECT_EQ(cone(1, lane).exponent, 20);
    }
}

TEST_F(LowerEmission, SolarIsDistant) {
    lower("solar(vector(0, -2, 0), .1) Cl = 1;");
    EXPECT_TRUE(whole().emissions.at(0).distant);
    expectNear(cone(0).axis, {0, -2, 0});
    EXPECT_NEAR(cone(0).angle, 36 / std::numbers::pi_v<float>, 1e-4);
    lower("solar() Cl = 1;");
    EXPECT_EQ(cone(0).angle, 360);
    lower("solar(1, vector(0, 1, 0), 2, 0, 3) Cl = 1;");
    EXPECT_EQ(cone(0).angle, 2);
    EXPECT_EQ(cone(0).importance, 3);
}

TEST_F(LowerEmission, LanesThatDoNotReachAStatementLeaveItsPlanes) {
    lower("if (u < 0) illuminate(from) Cl = 1; else solar(vector(0, 0, 1), 0) Cl = 2;");
    ASSERT_EQ(facts_.cones.size(), 2u);
    int both[2] = {0, 0};
    for (int lane = 0; lane < run_->batch->count; ++lane) {
        const int taken = run_->input(ShaderInput::u, lane) < 0 ? 0 : 1;
        ++both[taken];
        EXPECT_EQ(cone(taken, lane).importance, 1) << lane;
        EXPECT_EQ(cone(1 - taken, lane).importance, unreached) << lane;
    }
    EXPECT_GT(both[0] * both[1], 0);
}

TEST_F(LowerEmission, InLoopsAStatementIsSaidToRepeat) {
    lower("float i; for (i = 0; i < turns; i += 1) illuminate(from + i) Cl = 1;");
    ASSERT_EQ(whole().emissions.size(), 1u);
    EXPECT_TRUE(whole().emissions[0].repeated);
    lower("illuminate(from) Cl = 1;");
    EXPECT_FALSE(whole().emissions[0].repeated);
}

TEST_F(LowerEmission, ConesThatDependOnWhatIsLitAreNoEmission) {
    lower("illuminate(from, Ps - from, half) Cl = 1;");
    EXPECT_FALSE(facts_.conesAreTheLights);
}

TEST_F(LowerEmission, TheLightItselfStatesNothing) {
    lower("if (u < 0) illuminate(from) Cl = 1;");
    const Function light = slice(whole(), Question::Light);
    EXPECT_FALSE(
        anyInstruction(light.body, [](const Instruction &i) { return i.op == Op::EmissionCone; }));
    for (const OutputSlot &slot : light.outputs)
        EXPECT_TRUE(slot.name == OutputKind::L || slot.name == OutputKind::Cl);
}

TEST_F(LowerEmission, FoldingKeepsTheCones) {
    lower("if (turns > 2) illuminate(from, vector(0, 0, 1), half) Cl = 1;"
          "else illuminate(from) Cl = 2;");
    int turns = -1, half = -1;
    for (int slot = 0; slot < int(whole().parameters.size()); ++slot) {
        turns = whole().parameters[slot].name == "turns" ? slot : turns;
        half = whole().parameters[slot].name == "half" ? slot : half;
    }
    const Function folded = fold(whole(), {{turns, 5}, {half, .25f}});
    const Function emission = slice(folded, Question::Emission);
    const auto planes = run_->batch->run(emission, interpret, unreached);
    const LightFacts facts = lightFacts(folded);
    ASSERT_EQ(facts.cones.size(), 2u); // Numbers stay.
    EXPECT_NEAR(planes[size_t(facts.cones[0].angle)][0], 90 / std::numbers::pi_v<float>, 1e-4);
    EXPECT_EQ(planes[size_t(facts.cones[1].importance)][0], unreached);
}

} // namespace
} // namespace candela::ir
