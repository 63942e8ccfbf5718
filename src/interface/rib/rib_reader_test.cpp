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
    EXPECT_EQ(world.options.format.xResolution, 320);
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

TEST_F(Reading, allSpellingsOfASphereAreOne) {
    auto scene = world("Sphere 1 -1 1 360\nSphere [1 -1 1 360]\nSphere[1.0 -1e0 +1 3.6E2]\n"
                       "Sphere 1 # radius\n -1 # zmin\n 1 [360]");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(scene.primitives.size(), 4u);
    for (const auto &primitive : scene.primitives) {
        const auto &sphere = std::get<SphereRecord>(primitive.record->shape);
        EXPECT_EQ(sphere.radius, 1);
        EXPECT_EQ(sphere.zMin, -1);
        EXPECT_EQ(sphere.thetaMax, 360);
    }
}

TEST_F(Reading, bracketsAreOptionalWhereTheNumberIsFixed) {
    auto scene = world("Color 1 0 0 Sphere 1 -1 1 360 Color [0 1 0] Sphere 1 -1 1 360\n"
                       "Transform 1 0 0 0 0 1 0 0 0 0 1 0 3 0 0 1 Sphere 1 -1 1 360\n"
                       "Transform [1 0 0 0 0 1 0 0 0 0 1 0 4 0 0 1] Sphere 1 -1 1 360\n"
                       "Translate [1 0 0] Sphere 1 -1 1 360\n"
                       "Basis \"b-spline\" 1 [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1] [4]\n"
                       "Disk 0 1 360\n");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(scene.primitives.size(), 6u);
    EXPECT_EQ(scene.primitives[0].attributes->color, Color(1, 0, 0));
    EXPECT_EQ(scene.primitives[1].attributes->color, Color(0, 1, 0));
    EXPECT_EQ(scene.primitives[2].place(0, 0, 0).x, 3);
    EXPECT_EQ(scene.primitives[3].place(0, 0, 0).x, 4);
    EXPECT_EQ(scene.primitives[4].place(0, 0, 0).x, 5);
    EXPECT_EQ(scene.primitives[5].attributes->uBasis.step, 1);
    EXPECT_EQ(scene.primitives[5].attributes->vBasis.step, 4);
}

TEST_F(Reading, parametersHaveManySpellings) {
    auto scene =
        world("Declare \"heat\" \"constant float\"\n"
              "Sphere 1 -1 1 360 \"heat\" 3\n"
              "Sphere 1 -1 1 360 \"heat\" [3]\n"
              "Sphere 1 -1 1 360 \"uniform float heat\" 3 \"constant string label\" \"x\"\n"
              "Sphere 1 -1 1 360 \"uniform float[2] dims\" [1 2.5] # a pair\n"
              "Disk 0 1 360 \"heat\" # later\n [ 3 # three\n ]");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(scene.primitives.size(), 5u);
    for (int i : {0, 1, 2, 4})
        EXPECT_EQ(scene.primitives[i].record->variables.number("heat", 0), 3);
    EXPECT_EQ(scene.primitives[2].record->variables.string("label", ""), "x");
    EXPECT_EQ(scene.primitives[3].record->variables.find("dims")->floats, (Floats{1, 2.5f}));
}

TEST_F(Reading, handlesAreNumbersOrStrings) {
    auto scene = world("LightSource \"pointlight\" 7 Illuminate 7 0\n"
                       "LightSource \"pointlight\" \"key light\" Sphere 1 -1 1 360\n"
                       "ObjectBegin \"ball\" Sphere 1 -1 1 360 ObjectEnd\n"
                       "ObjectInstance \"ball\"\nObjectBegin 3 Disk 0 1 360 ObjectEnd\n"
                       "ObjectInstance 3");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(scene.lights[1]->handle, "key light");
    ASSERT_EQ(scene.primitives.size(), 1u);
    EXPECT_EQ(scene.primitives[0].attributes->lightsOn, (std::vector{1}));
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.instances[0].object, 0);
    EXPECT_EQ(scene.instances[1].object, 1);
}

TEST_F(Reading, optionalArgumentsMayBeAbsent) {
    read("DepthOfField 2.8 0.05 3 WorldBegin WorldEnd DepthOfField WorldBegin\n"
         "SubdivisionMesh \"catmull-clark\" [3] [0 1 2] \"P\" [0 0 0 1 0 0 1 1 0]\n"
         "SubdivisionMesh \"catmull-clark\" [3] [0 1 2] [\"crease\"] [2 1] [0 1] [3] \"P\" "
         "[0 0 0 1 0 0 1 1 0]\n"
         "SubdivisionMesh \"catmull-clark\" [3] [0 1 2] [\"crease\"] [2 1] [0 1] [3] [] \"P\" "
         "[0 0 0 1 0 0 1 1 0]\n"
         "WorldEnd");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(builder.worlds[1].primitives.size(), 3u);
    EXPECT_EQ(builder.worlds[0].options.camera.fStop, 2.8f);
    EXPECT_EQ(builder.worlds[1].options.camera.fStop, 0);
}

TEST_F(Reading, requestsOfLaterVersionsAreReadToTheirEnd) {
    auto scene = world("TrimCurve [1] [2] [0 0 1 1] [0] [1] [2] [0 1] [0 1] [1 1]\n"
                       "Detail [-1 1 -1 1 -1 1]\nDetailRange 0 0 1 1\n"
                       "MotionBegin [0 1] Translate 0 0 0 Translate 1 0 0 MotionEnd\n"
                       "SolidBegin \"primitive\" Sphere 1 -1 1 360 SolidEnd\n");
    EXPECT_EQ(errors(), 0) << found.text();
    EXPECT_EQ(warnings(), 0);
    EXPECT_EQ(scene.primitives.size(), 1u);
    read("Imager \"background\" MakeTexture \"a\" \"b\" \"clamp\" \"black\" \"box\" 1 1\n"
         "MakeShadow \"a\" \"b\" MakeLatLongEnvironment \"a\" \"b\" \"box\" 1 1\n"
         "MakeBump \"a\" \"b\" \"clamp\" \"black\" \"box\" 1 1 ColorSamples [1 1 1] [1 1 1]\n"
         "MakeCubeFaceEnvironment \"a\" \"b\" \"c\" \"d\" \"e\" \"f\" \"g\" 90 \"box\" 1 1\n");
    EXPECT_EQ(errors(), 0) << found.text();
}

TEST_F(Reading, lineEndsAndAMissingLastOneDoNotMatter) {
    std::string text = "# caf\xe9\nWorldBegin\n\tSphere 1 -1 1 360 # x\n\tColor 1 0\n 0\nWorldEnd";
    for (const char *lineEnd : {"\n", "\r\n", "\r", "\x1a\n"}) { // As DOS ended files.
        std::string other;
        for (char c : text)
            other += c == '\n' ? std::string(lineEnd) : std::string(1, c);
        read(other);
        EXPECT_EQ(found.text(), "");
        EXPECT_TRUE(builder.worlds.back().ended);
        EXPECT_EQ(builder.worlds.back().primitives.size(), 1u);
        EXPECT_EQ(builder.worlds.back().primitives[0].record->where.line, 3);
    }
}

TEST_F(Reading, requestsOfOtherRenderersAreWarnedAboutOnceAKind) {
    const ListeningSceneBuilder::World seen = world(
        "Camera \"main\" \"fov\" [30]\nVolumePixelSamples 2 2\nVolumePixelSamples 4 4\n"
        "ShaderLayer \"surface\" \"plastic\" \"base\" \"float Kd\" [.5]\n"
        "Volume \"box\" [-1 1 -1 1 -1 1] [0 0 0] \"float d\" [1]\nBxdf \"PxrDiffuse\" \"b1\"\n"
        "Pattern \"PxrTexture\" \"t\" \"string filename\" [\"x\"]\nEditBegin "
        "\"rerender\"\nEditEnd\n"
        "System \"ls\"\nSphere 1 -1 1 360");
    EXPECT_EQ(errors(), 0) << found.text();
    EXPECT_EQ(warnings(), 9) << found.text();
    EXPECT_TRUE(says("Camera: this version leaves it out: it belongs to other renderers"));
    EXPECT_EQ(seen.primitives.size(), 1u);
}

TEST_F(Reading, slipsThatOldReadersForgaveAreForgivenWithOneWarningAKind) {
    const ListeningSceneBuilder::World seen =
        world("Surface 'marble' 'scale' [2];\nColor [1, 0.5, 0];\nSphere 1 -1 1 360;");
    EXPECT_EQ(errors(), 0) << found.text();
    EXPECT_EQ(warnings(), 2) << found.text();
    ASSERT_EQ(seen.primitives.size(), 1u);
    EXPECT_EQ(seen.primitives[0].attributes->color, Color(1, .5f, 0));
    EXPECT_EQ(seen.primitives[0].attributes->surface->parameters.number("scale", 0), 2);
}

} // namespace candela::testing
