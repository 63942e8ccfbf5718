// SPDX-License-Identifier: Apache-2.0
// Atmosphere, Interior and Exterior: attributes like others.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

TEST_F(State, volumesAreAttributesOfPrimitives) {
    state.worldBegin(at);
    state.translate(at, 1, 2, 3);
    state.atmosphere(at, "fog", numbers("float distance", {5}));
    state.attributeBegin(at);
    state.interior(at, "water", {});
    state.exterior(at, "smoke", {});
    sphere();
    const std::shared_ptr<const Attributes> all = primitives().back().attributes;
    state.atmosphere(at, "null", {});
    state.interior(at, "", {});
    sphere();
    const std::shared_ptr<const Attributes> fewer = primitives().back().attributes;
    state.attributeEnd(at);
    sphere();
    const std::shared_ptr<const Attributes> after = primitives().back().attributes;

    ASSERT_TRUE(all->atmosphere && all->interior && all->exterior);
    EXPECT_EQ(all->atmosphere->name, "fog");
    EXPECT_EQ(all->atmosphere->parameters.number("distance", 0), 5);
    EXPECT_EQ(all->atmosphere->currentFromShader.atOpen(), translation(1, 2, 3));
    EXPECT_EQ(all->interior->name, "water");
    EXPECT_EQ(all->exterior->name, "smoke");
    EXPECT_FALSE(fewer->atmosphere);
    EXPECT_FALSE(fewer->interior);
    EXPECT_TRUE(fewer->exterior);
    EXPECT_TRUE(after->atmosphere);
    EXPECT_FALSE(after->interior || after->exterior);
    EXPECT_EQ(errors(), 0);
}

} // namespace candela::testing
