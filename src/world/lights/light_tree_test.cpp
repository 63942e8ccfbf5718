// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_tree.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

using namespace candela;

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

class Random {
public:
    explicit Random(int seed) : engine_(seed) {}
    float operator()(float low = 0, float high = 1) { return low + (high - low) * unit_(engine_); }
    Vec3 inBox(Vec3 low, Vec3 high) {
        return {(*this)(low.x, high.x), (*this)(low.y, high.y), (*this)(low.z, high.z)};
    }
    Vec3 direction() {
        for (;;)
            if (Vec3 v = inBox({-1, -1, -1}, {1, 1, 1}); dot(v, v) > 0.01f && dot(v, v) < 1)
                return normalize(v);
    }
    /// A direction at most `spread` from the axis.
    Vec3 about(Vec3 axis, float spread) {
        Vec3 s, t;
        orthonormalBasis(axis, s, t);
        float angle = (*this)(0, spread), turn = (*this)(0, 2 * pi);
        Vec3 across = s * std::cos(turn) + t * std::sin(turn);
        return axis * std::cos(angle) + across * std::sin(angle);
    }

private:
    std::mt19937 engine_;
    std::uniform_real_distribution<float> unit_{0, 1};
};

EmitterBound lamp(Vec3 at, float power) { return {{at, at}, {}, pi, pi, power}; }

std::vector<EmitterBound> lamps(int count, float size, int seed) {
    Random random(seed);
    std::vector<EmitterBound> emitters(count);
    for (EmitterBound &e : emitters) {
        Vec3 at = random.inBox({}, {1, 1, 1}) * size;
        e = lamp(at, random() * random());
    }
    return emitters;
}

/// Boxes with cones of all widths.
std::vector<EmitterBound> spots(int count, Random &random) {
    std::vector<EmitterBound> emitters(count);
    for (EmitterBound &e : emitters) {
        Vec3 at = random.inBox({}, {4, 4, 4}), half = random.inBox({}, {1, 1, 1}) * random(0, 0.5f);
        e.box = {at - half, at + half};
        e.axis = random() < 0.1f ? Vec3{} : random.direction();
        e.normalSpread = random() < 0.3f ? 0 : random(0, random() < 0.5f ? 0.3f : pi);
        e.emissionSpread = random() < 0.5f ? pi / 2 : random(0, pi);
        e.power = std::exp(random(-5, 5));
    }
    return emitters;
}

struct Chosen {
    std::int32_t emitter;
    float probability;
    double u;
};

Chosen choose(const LightTree &tree, Vec3 p, Vec3 n, double u) {
    const float *P[3] = {&p.x, &p.y, &p.z}, *N[3] = {&n.x, &n.y, &n.z};
    Chosen c{-2, -1, u};
    tree.choose(1, P, N, &c.u, &c.emitter, &c.probability);
    return c;
}

float probability(const LightTree &tree, Vec3 p, Vec3 n, std::int32_t emitter) {
    const float *P[3] = {&p.x, &p.y, &p.z}, *N[3] = {&n.x, &n.y, &n.z};
    float result = -1;
    tree.probability(1, P, N, &emitter, &result);
    return result;
}

double sumOfProbabilities(const LightTree &tree, Vec3 p, Vec3 n) {
    double sum = 0;
    for (int e = 0; e < tree.size(); ++e)
        sum += probability(tree, p, n, e);
    return sum;
}

/// Draws strata of u; checks bits, frequencies and that u is uniform after.
void expectSoundChoice(const LightTree &tree, Vec3 p, Vec3 n, int draws) {
    std::vector<int> counts(tree.size()), lower(tree.size());
    int nothing = 0;
    for (int i = 0; i < draws; ++i) {
        Chosen c = choose(tree, p, n, (i + 0.5) / draws);
        ASSERT_TRUE(c.u >= 0 && c.u < 1);
        if (c.emitter < 0) {
            EXPECT_EQ(c.probability, 0);
            ++nothing;
            continue;
        }
        ASSERT_LT(c.emitter, tree.size());
        ASSERT_GT(c.probability, 0);
        ASSERT_EQ(c.probability, probability(tree, p, n, c.emitter));
        ++counts[c.emitter], lower[c.emitter] += c.u < 0.5;
    }
    for (int e = 0; e < tree.size(); ++e) {
        // An emitter's share of u is one interval, so strata count it but for the ends.
        double expected = double(probability(tree, p, n, e)) * draws;
        EXPECT_NEAR(counts[e], expected, 2);
        EXPECT_NEAR(lower[e], expected / 2, 2);
    }
    // Branches that lead nowhere are intervals of their own.
    EXPECT_NEAR(sumOfProbabilities(tree, p, n) + double(nothing) / draws, 1,
                double(tree.size() + 2) / draws);
}

} // namespace

TEST(LightTree, ChoicesHaveTheirProbabilityAndLeaveUUniform) {
    LightTree tree(lamps(300, 1, 1));
    for (Vec3 p : {Vec3{0.3f, 0.4f, 0.5f}, Vec3{9, 1, 1}, Vec3{-1000, 0, 0}}) {
        expectSoundChoice(tree, p, {}, 50000);
        EXPECT_NEAR(sumOfProbabilities(tree, p, {}), 1, 1e-5);
        expectSoundChoice(tree, p, {0, 0.6f, 0.8f}, 50000);
    }
    Random random(7);
    for (int trial = 0; trial < 20; ++trial) {
        LightTree some(spots(20, random));
        expectSoundChoice(some, random.inBox({-1, -1, -1}, {5, 5, 5}), random.direction(), 20000);
    }
}

TEST(LightTree, WhoeverCanShineMayBeChosen) {
    Random random(2);
    int shone = 0, culled = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<EmitterBound> emitters = spots(1 + trial % 40, random);
        LightTree tree(emitters);
        Vec3 p = random.inBox({-2, -2, -2}, {6, 6, 6});
        Vec3 n = trial % 3 ? random.direction() : Vec3{};
        for (int e = 0; e < tree.size(); ++e) {
            const EmitterBound &bound = emitters[e];
            bool can = false;
            for (int ray = 0; ray < 16 && !can; ++ray) {
                Vec3 to = random.inBox(bound.box.low, bound.box.high) - p;
                Vec3 normal = bound.axis == Vec3{} ? random.direction()
                                                   : random.about(bound.axis, bound.normalSpread);
                float cosine = -dot(to, normal) / length(to);
                can = std::acos(std::clamp(cosine, -1.0f, 1.0f)) <= bound.emissionSpread &&
                      (n == Vec3{} || dot(to, n) > 0);
            }
            float chance = probability(tree, p, n, e);
            EXPECT_TRUE(!can || chance > 0);
            shone += can, culled += !(chance > 0);
        }
    }
    EXPECT_GT(shone, 1000);
    EXPECT_GT(culled, 1000);
}

/// Behind a loose emitter light is unlikely, not impossible.
TEST(LightTree, LooseEmittersAreChosenRarelyBeyondTheirSpread) {
    std::vector<EmitterBound> two;
    for (float z : {1.0f, -1.0f})
        two.push_back({{{0, 0, 2}, {0.1f, 0.1f, 2}}, {0, 0, z}, 0, pi / 2, 1, true});
    const LightTree tree(two);
    EXPECT_GT(probability(tree, {0, 0, 0}, {}, 0), 1e-3);
    EXPECT_LT(probability(tree, {0, 0, 0}, {}, 0), 0.02);
    EXPECT_GT(probability(tree, {0, 0, 4}, {}, 0), 0.98);
    two[0].isLoose = two[1].isLoose = false;
    EXPECT_EQ(probability(LightTree(two), {0, 0, 0}, {}, 0), 0);
    // Nor does joining make them strict.
    Random random(3);
    std::vector<EmitterBound> many = spots(50, random);
    for (EmitterBound &e : many)
        e.isLoose = true;
    const LightTree loose(many);
    for (int i = 0; i < 50; ++i) {
        const Vec3 p = random.inBox({-8, -8, -8}, {12, 12, 12});
        for (int e = 0; e < 50; ++e)
            EXPECT_GT(probability(loose, p, {}, e), 0);
        EXPECT_NEAR(sumOfProbabilities(loose, p, {}), 1, 1e-5);
    }
}

/// Batches are walked together; what they choose is what each point chooses alone.
TEST(LightTree, BatchesChooseWhatPointsChooseAlone) {
    Random random(9);
    const LightTree tree(spots(700, random));
    constexpr int count = 100;
    float P[3][count], N[3][count], probabilities[count];
    double u[count], before[count];
    std::int32_t emitters[count];
    for (int i = 0; i < count; ++i) {
        const Vec3 p = random.inBox({-1, -1, -1}, {5, 5, 5}), n = random.direction();
        for (int k = 0; k < 3; ++k)
            P[k][i] = p[k], N[k][i] = i % 3 ? n[k] : 0;
        before[i] = u[i] = random();
    }
    const float *p[3] = {P[0], P[1], P[2]}, *n[3] = {N[0], N[1], N[2]};
    tree.choose(count, p, n, u, emitters, probabilities);
    for (int i = 0; i < count; ++i) {
        const Chosen alone =
            choose(tree, {P[0][i], P[1][i], P[2][i]}, {N[0][i], N[1][i], N[2][i]}, before[i]);
        EXPECT_EQ(alone.emitter, emitters[i]);
        EXPECT_EQ(alone.probability, probabilities[i]);
        EXPECT_EQ(alone.u, u[i]);
    }
}

TEST(LightTree, AllSizesChooseAlike) {
    std::vector<EmitterBound> unit = lamps(100, 1, 3);
    LightTree reference(unit);
    for (float size : {1e-9f, 1e-3f, 1e3f, 1e9f}) {
        LightTree tree(lamps(100, size, 3));
        for (Vec3 p : {Vec3{0.5f, 0.5f, 0.5f}, Vec3{3, 0, 0}})
            for (int e = 0; e < 100; ++e) {
                float expected = probability(reference, p, {0, 1, 0}, e);
                EXPECT_NEAR(probability(tree, p * size, {0, 1, 0}, e), expected, expected * 1e-3f);
            }
    }
}

TEST(LightTree, CoincidentEmittersShareByPower) {
    std::vector<EmitterBound> emitters;
    for (int i = 1; i <= 10; ++i)
        emitters.push_back(lamp({1, 2, 3}, float(i)));
    LightTree tree(emitters);
    for (Vec3 p : {Vec3{}, Vec3{1, 2, 3}})
        for (int i = 1; i <= 10; ++i)
            EXPECT_NEAR(probability(tree, p, {}, i - 1), i / 55.0, 1e-6);
}

TEST(LightTree, PointsInBoxesReachAllOfThem) {
    std::vector<EmitterBound> emitters;
    for (int i = 0; i < 16; ++i)
        emitters.push_back({{{-1, -1, -1}, {1, 1, 1}}, {0, 0, 1}, 0, pi / 2, 1});
    LightTree tree(emitters);
    for (Vec3 p : {Vec3{}, Vec3{0.9f, -0.9f, -0.9f}, Vec3{1, 1, 1}}) {
        EXPECT_NEAR(sumOfProbabilities(tree, p, {0, 0, 1}), 1, 1e-6);
        expectSoundChoice(tree, p, {0, 0, -1}, 1000);
    }
}

TEST(LightTree, BlackAndBrokenEmittersAreNeverChosen) {
    std::vector<EmitterBound> emitters = lamps(20, 1, 4);
    emitters[3].power = 0, emitters[4].power = -1, emitters[5].power = notANumber;
    emitters[6].power = Box3::infinity, emitters[7].box = {}, emitters[8].box.low.x = notANumber;
    emitters[9].box.high = {1e30f, 1e30f, 1e30f};
    LightTree tree(emitters);
    for (Vec3 p : {Vec3{0.5f, 0.5f, 0.5f}, Vec3{notANumber, 0, 0}, Vec3{1e30f, 0, 0}})
        for (Vec3 n : {Vec3{}, Vec3{notANumber, 0, 1}}) {
            for (int e = 3; e < 10; ++e)
                EXPECT_EQ(probability(tree, p, n, e), 0);
            expectSoundChoice(tree, p, n, 10000);
            EXPECT_NEAR(sumOfProbabilities(tree, p, n), 1, 1e-5);
            EXPECT_GE(choose(tree, p, n, notANumber).emitter, 0);
        }
    // Broken directions bound nothing: light may go anywhere.
    EmitterBound broken = lamp({}, 1);
    broken.axis = {notANumber, 0, 1}, broken.normalSpread = notANumber,
    broken.emissionSpread = notANumber;
    EXPECT_EQ(probability(LightTree(std::vector{broken}), {0, 0, -1}, {}, 0), 1);
    for (int count : {0, 1, 5}) {
        LightTree black(std::vector<EmitterBound>(count, lamp({1, 1, 1}, 0)));
        EXPECT_EQ(choose(black, {}, {}, 0.5).emitter, -1);
        EXPECT_EQ(sumOfProbabilities(black, {}, {}), 0);
    }
    EXPECT_EQ(probability(tree, {}, {}, -1), 0);
    EXPECT_EQ(probability(tree, {}, {}, 20), 0);
}

TEST(LightTree, FaintEmittersStayPossible) {
    LightTree tree(std::vector{lamp({}, 1e-38f), lamp({1, 0, 0}, 1e38f), lamp({2, 0, 0}, 1e-44f)});
    for (int e = 0; e < 3; ++e)
        EXPECT_GT(probability(tree, {0, 5, 0}, {}, e), 0);
}

TEST(LightTree, EstimatesIrradiance) {
    EmitterBound isotropic = lamp({0, 0, 2}, 16 * pi), lambertian = isotropic, leaf = isotropic;
    lambertian.axis = {0, 0, -1}, lambertian.normalSpread = 0, lambertian.emissionSpread = pi / 2;
    lambertian.power = 4 * pi;
    leaf.axis = {0, 0, 1}, leaf.normalSpread = 0, leaf.power = 8 * pi;
    Vec3 p, n{0, 0.6f, 0.8f};
    const float *P[3] = {&p.x, &p.y, &p.z}, *N[3] = {&n.x, &n.y, &n.z};
    for (EmitterBound bound : {isotropic, lambertian, leaf}) {
        double E;
        LightTree(std::vector{bound}).irradiance(1, P, N, &E);
        EXPECT_NEAR(E, 0.8, 1e-6);
    }
}

TEST(LightTree, HundredThousandEmittersSumToOne) {
    LightTree tree(lamps(100000, 1, 5));
    EXPECT_NEAR(sumOfProbabilities(tree, {0.3f, 0.4f, 0.5f}, {}), 1, 1e-4);
    for (int i = 0; i < 1000; ++i) {
        Chosen c = choose(tree, {0.3f, 0.4f, 0.5f}, {0, 0, 1}, (i + 0.5) / 1000);
        EXPECT_EQ(c.probability, probability(tree, {0.3f, 0.4f, 0.5f}, {0, 0, 1}, c.emitter));
    }
    // Lines of lamps at ever greater distances make the deepest trees.
    std::vector<EmitterBound> line;
    for (int i = 0; i < 100; ++i)
        line.push_back(lamp({std::exp2(float(i) / 2 - 30), 0, 0}, 1));
    LightTree deep(line);
    EXPECT_NEAR(sumOfProbabilities(deep, {0, 1, 0}, {}), 1, 1e-5);
    expectSoundChoice(deep, {0, 1, 0}, {}, 10000);
}

TEST(LightTree, BeatsTheChoiceByPowerInAHall) {
    // 1,000 downlights of unequal power under the ceiling of a hall, points on the floor.
    Random random(6);
    std::vector<EmitterBound> emitters;
    double total = 0;
    for (int i = 0; i < 1000; ++i) {
        Vec3 at{random(0, 100), random(0, 100), 4};
        emitters.push_back({{at, at}, {0, 0, -1}, 0, pi / 2, std::exp(random(-3, 3))});
        total += emitters.back().power;
    }
    LightTree tree(emitters);
    double ofTree = 0, ofPower = 0;
    for (int point = 0; point < 100; ++point) {
        Vec3 p{random(0, 100), random(0, 100), 0}, up{0, 0, 1};
        double E = 0, squaresOfTree = 0, squaresOfPower = 0;
        for (int e = 0; e < tree.size(); ++e) {
            Vec3 to = emitters[e].box.low - p;
            double d2 = dot(to, to), f = emitters[e].power / pi * 16 / (d2 * d2);
            E += f;
            squaresOfTree += f * f / probability(tree, p, up, e);
            squaresOfPower += f * f * total / emitters[e].power;
        }
        ofTree += (squaresOfTree - E * E) / (E * E), ofPower += (squaresOfPower - E * E) / (E * E);
    }
    RecordProperty("variance_ratio", std::to_string(ofPower / ofTree));
    // Lamps within some 5 m give most of the light: 1 in 130 choices by power finds them.
    EXPECT_GT(ofPower / ofTree, 50);
}
