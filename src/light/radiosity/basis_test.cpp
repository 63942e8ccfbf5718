// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/basis.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::radiosity {
namespace {

/// A polynomial that the basis of an order holds.
double polynomial(int order, Place at) {
    const double u = at.u, v = at.v;
    return order == 1   ? 3
           : order == 2 ? 1 + 2 * u - v
                        : 1 + 2 * u - v + 3 * u * u - u * v + 0.5 * v * v;
}

struct Case {
    bool triangle;
    int order;
};

class OfEachOrder : public testing::TestWithParam<Case> {
protected:
    const Basis &basis = Basis::of(GetParam().triangle, GetParam().order);
};

TEST_P(OfEachOrder, ValuesAtNodesTellPolynomialsAnywhere) {
    for (const Place at : {Place{0.1f, 0.2f}, Place{0.7f, 0.1f}, Place{0, 0}, Place{0.3f, 0.6f}}) {
        float value[mostNodes];
        basis.values(at, value);
        double sum = 0, all = 0;
        for (int i = 0; i < basis.nodes(); ++i) {
            sum += value[i] * polynomial(GetParam().order, basis.node(i));
            all += value[i];
        }
        EXPECT_NEAR(sum, polynomial(GetParam().order, at), 1e-5);
        EXPECT_NEAR(all, 1, 1e-5);
    }
}

TEST_P(OfEachOrder, TheRuleIntegratesProductsExactly) {
    // The integral of u v is 1/4 of a square and 1/24 of a triangle; of 1 the domain's area.
    double area = 0, product = 0;
    for (int i = 0; i < basis.nodes(); ++i) {
        area += basis.weight(i);
        product += basis.weight(i) * basis.node(i).u * basis.node(i).v;
    }
    EXPECT_NEAR(area, GetParam().triangle ? 0.5 : 1, 1e-6);
    EXPECT_NEAR(product, GetParam().triangle ? 1.0 / 24 : 0.25, 1e-6);
}

TEST_P(OfEachOrder, ChildrenOfAPolynomialAreThatPolynomial) {
    for (int c = 0; c < Basis::children; ++c) {
        const Basis::ChildPlace child = Basis::child(GetParam().triangle, c);
        for (int i = 0; i < basis.nodes(); ++i) {
            double sum = 0;
            for (int j = 0; j < basis.nodes(); ++j)
                sum += basis.toChild(c, i, j) * polynomial(GetParam().order, basis.node(j));
            const Place own = basis.node(i);
            EXPECT_NEAR(sum,
                        polynomial(GetParam().order, {child.origin.u + child.scale * own.u,
                                                      child.origin.v + child.scale * own.v}),
                        2e-5);
        }
    }
}

/// A parent's values are those of the nearest polynomial: that of its children's if it is one, and
/// whatever the children hold, no light is lost.
TEST_P(OfEachOrder, ParentsKeepPolynomialsAndMeans) {
    for (int i = 0; i < basis.nodes(); ++i) {
        double sum = 0;
        for (int c = 0; c < Basis::children; ++c) {
            const Basis::ChildPlace child = Basis::child(GetParam().triangle, c);
            for (int j = 0; j < basis.nodes(); ++j) {
                const Place own = basis.node(j);
                sum += basis.fromChild(c, i, j) *
                       polynomial(GetParam().order, {child.origin.u + child.scale * own.u,
                                                     child.origin.v + child.scale * own.v});
            }
        }
        EXPECT_NEAR(sum, polynomial(GetParam().order, basis.node(i)), 3e-5);
    }
    for (int c = 0; c < Basis::children; ++c)
        for (int j = 0; j < basis.nodes(); ++j) {
            double mean = 0;
            for (int i = 0; i < basis.nodes(); ++i)
                mean += basis.weight(i) * basis.fromChild(c, i, j);
            EXPECT_NEAR(mean, basis.weight(j) / 4, 1e-6);
        }
}

TEST_P(OfEachOrder, PlacesFindTheirChildren) {
    for (int c = 0; c < Basis::children; ++c) {
        const Basis::ChildPlace child = Basis::child(GetParam().triangle, c);
        for (int i = 0; i < basis.nodes(); ++i) {
            const Place own = basis.node(i);
            Place at{child.origin.u + child.scale * own.u, child.origin.v + child.scale * own.v};
            EXPECT_EQ(Basis::childAt(GetParam().triangle, at), c);
            EXPECT_NEAR(at.u, own.u, 1e-6);
            EXPECT_NEAR(at.v, own.v, 1e-6);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Bases, OfEachOrder,
                         testing::Values(Case{false, 1}, Case{false, 2}, Case{false, 3},
                                         Case{true, 1}, Case{true, 2}, Case{true, 3}),
                         [](const testing::TestParamInfo<Case> &info) {
                             return std::string(info.param.triangle ? "Triangle" : "Square") +
                                    std::to_string(info.param.order);
                         });

} // namespace
} // namespace candela::radiosity
