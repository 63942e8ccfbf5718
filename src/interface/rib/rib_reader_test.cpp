// SPDX-License-Identifier: Apache-2.0
// Well-formed RIB in all its spellings.
#include "interface/rib/reading_fixture.h"

namespace candela::testing {

TEST_F(Reading, bringsASceneToTheBuilder) {
    read("##RenderMan RIB-Structure 1.0\nversion 3.04\nFormat 320 240 1\n"
         "Display \"out.exr\" \"openexr\" \"rgba\"\n"
         "Projection \"perspective\" \"fov\" [40]\nTranslate 0 0 5\nWorldBegin\n"
         "LightSource \"distantlight\" 1 \"intensity\" 2 \"to\" [0 0 1]\n"
         "AttributeBegin Color [1 0 0] Surface \"matte\" \"Kd\" .5\n"
         "Sphere 1 -1 1 360\nAttributeEnd\n"
         "Polygon \"P\" [0 0 0  1 0 0  1 1 0]\nWorldEnd\n");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(builder.worlds.size(), 1u);
    const auto &world = builder.worlds[0];
    EXPECT_TRUE(world.ended);
    EXPECT_EQ(world.options.xResolution, 320);
    EXPECT_TRUE(world.options.camera.perspective);
    EXPECT_EQ(world.options.camera.fieldOfView, 40);
    EXPECT_EQ(world.options.camera.cameraFromWorld, translation(0, 0, 5));
    ASSERT_EQ(world.lights.size(), 1u);
    EXPECT_EQ(world.lights[0]->shader.parameters.number("intensity", 0), 2);
    ASSERT_EQ(world.primitives.size(), 2u);
    EXPECT_EQ(std::get<SphereRecord>(world.primitives[0].record->shape).thetaMax, 360);
    EXPECT_EQ(world.primitives[0].attributes->color, Color(1, 0, 0));
    EXPECT_EQ(world.primitives[0].attributes->surface->parameters.number("Kd", 0), 0.5f);
    EXPECT_EQ(world.primitives[0].place(0, 0, 0), (Vec3{0, 0, 5}));
    EXPECT_EQ(world.primitives[1].attributes->color, Color(1));
    EXPECT_EQ(world.primitives[1].record->variables.find("P")->floats.size(), 9u);
}

} // namespace candela::testing
