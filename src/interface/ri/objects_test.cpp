// SPDX-License-Identifier: Apache-2.0
// Object definitions and their instances.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

TEST_F(State, instancesTakeAttributesAndPlaceOfTheirTime) {
    state.worldBegin(at);
    state.color(at, Color(1, 0, 0));
    state.translate(at, 7, 7, 7); // Is no part of the definition.
    state.objectBegin(at, {"1"});
    state.translate(at, 0, 1, 0);
    sphere();
    state.objectEnd(at);
    EXPECT_TRUE(primitives().empty());
    state.identity(at);
    state.color(at, Color(0, 0, 1));
    state.translate(at, 5, 0, 0);
    state.objectInstance(at, {"1"});
    state.scale(at, 2, 2, 2);
    state.objectInstance(at, {"1"});
    sphere();
    const auto &world = builder.worlds.back();
    ASSERT_EQ(world.objects.at(0).primitives.size(), 1u);
    EXPECT_EQ(world.objects.at(0).primitives[0].place(0, 0, 0), (Vec3{0, 1, 0}));
    ASSERT_EQ(world.instances.size(), 2u);
    EXPECT_EQ(world.instances[0].object, 0);
    EXPECT_EQ(world.instances[0].attributes->color, Color(0, 0, 1));
    EXPECT_EQ(world.instances[0].currentFromObject.atOpen(), translation(5, 0, 0));
    EXPECT_EQ(world.instances[1].currentFromObject.atOpen(),
              scaling(2, 2, 2) * translation(5, 0, 0));
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{5, 0, 0})); // Nothing leaks out.
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, definitionsStartAtTheIdentity) {
    state.translate(at, 0, 0, 9); // The camera.
    state.worldBegin(at);
    state.translate(at, 4, 0, 0);
    state.objectBegin(at, {"o"});
    state.transformBegin(at);
    state.transform(at, translation(0, 0, 3));
    sphere();
    state.transformEnd(at);
    state.translate(at, 1, 1, 1);
    state.identity(at);
    sphere();
    state.objectEnd(at);
    sphere();
    const auto &parts = builder.worlds.back().objects.at(0).primitives;
    EXPECT_EQ(parts[0].place(0, 0, 0), (Vec3{0, 0, 3}));
    EXPECT_EQ(parts[1].place(0, 0, 0), (Vec3{0, 0, 0}));
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{4, 0, 9}));
}

TEST_F(State, whatShapesPrimitivesHoldsInDefinitions) {
    state.worldBegin(at);
    state.basis(at, "b-spline", 1, "b-spline", 1);
    state.objectBegin(at, {"o"});
    sphere();
    state.basis(at, "catmull-rom", 1, "catmull-rom", 1);
    state.textureCoordinates(at, 0, 0, 2, 0, 0, 2, 2, 2);
    sphere();
    state.objectEnd(at);
    sphere();
    EXPECT_EQ(errors() + warnings(), 0);
    const auto &parts = builder.worlds.back().objects.at(0).primitives;
    EXPECT_EQ(parts[0].attributes->uBasis.step, 1);
    EXPECT_EQ(parts[0].attributes->uBasis.matrix, last().uBasis.matrix);
    EXPECT_NE(parts[1].attributes->uBasis.matrix, last().uBasis.matrix);
    EXPECT_EQ(parts[1].attributes->textureCoordinates[2], 2);
    EXPECT_EQ(last().textureCoordinates[2], 1);
}

// RI 3.2, 5.6 has all attributes come from the instance; later RenderMan those that the object does
// not set.
TEST_F(State, objectsSetAttributesOfTheirOwn) {
    state.worldBegin(at);
    state.color(at, Color(1, 0, 0));
    state.attribute(at, "user", text("string mood", "calm"));
    state.objectBegin(at, {"o"});
    sphere();
    state.attributeBegin(at);
    state.color(at, Color(0, 1, 0));
    state.attribute(at, "user", text("string mood", "wild"));
    sphere();
    state.attributeEnd(at);
    state.sides(at, 1);
    sphere();
    state.objectEnd(at);
    const auto &parts = builder.worlds.back().objects.at(0).primitives;
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].attributes->ownSet, 0u);
    EXPECT_EQ(parts[1].attributes->ownSet, own::Color | own::Named);
    EXPECT_EQ(parts[1].attributes->ownNames, std::set<std::string>{"user:mood"});
    EXPECT_EQ(parts[2].attributes->ownSet, own::Sides);
    state.lightSource(at, "pointlight", {"l"}, {});
    EXPECT_EQ(errors() + warnings(), 0);
    state.objectBegin(at, {"p"});
    state.lightSource(at, "pointlight", {"l"}, {}); // Lights belong to the world.
    state.objectEnd(at);
    EXPECT_EQ(warnings(), 1);

    Attributes instance;
    instance.color = Color(0, 0, 1);
    instance.opacity = Color(.5f);
    instance.named["user:age"] = {"age", {}, {7}, {}};
    const Attributes merged = attributesOfPart(instance, *parts[1].attributes);
    EXPECT_EQ(merged.color, Color(0, 1, 0));
    EXPECT_EQ(merged.opacity, Color(.5f));
    EXPECT_EQ(merged.named.string("user:mood", ""), "wild");
    EXPECT_EQ(merged.named.number("user:age", 0), 7);
    EXPECT_EQ(attributesOfPart(instance, *parts[0].attributes).color, Color(0, 0, 1));
    EXPECT_EQ(attributesOfPart(instance, *parts[2].attributes).sides, 1);
}

TEST_F(State, objectsMayHoldInstancesButNotThemselves) {
    state.worldBegin(at);
    state.objectBegin(at, {"a"});
    sphere();
    state.objectInstance(at, {"a"});
    state.objectEnd(at);
    EXPECT_TRUE(says("no object 'a'"));
    state.objectBegin(at, {"b"});
    state.translate(at, 1, 0, 0);
    state.objectInstance(at, {"a"});
    state.objectInstance(at, {"a"});
    state.objectEnd(at);
    state.objectBegin(at, {"a"}); // "b" keeps the first.
    state.objectInstance(at, {"a"});
    state.objectEnd(at);
    state.objectInstance(at, {"b"});
    state.objectInstance(at, {"a"});
    state.objectInstance(at, {"c"});
    EXPECT_EQ(errors(), 2);
    const auto &world = builder.worlds.back();
    ASSERT_EQ(world.objects.size(), 3u);
    ASSERT_EQ(world.objects.at(1).instances.size(), 2u);
    EXPECT_EQ(world.objects.at(1).instances[1].object, 0);
    EXPECT_EQ(world.objects.at(1).instances[1].currentFromObject.atOpen(), translation(1, 0, 0));
    EXPECT_EQ(world.objects.at(2).instances[0].object, 0);
    ASSERT_EQ(world.instances.size(), 2u);
    EXPECT_EQ(world.instances[0].object, 1);
    EXPECT_EQ(world.instances[1].object, 2);
}

TEST_F(State, chainsOfObjectsHaveALimit) {
    for (bool inWorld : {false, true}) {
        if (inWorld)
            state.worldBegin(at);
        state.objectBegin(at, {"o"});
        sphere();
        state.objectEnd(at);
        const int before = errors();
        for (int i = 1; i < 64; ++i) {
            state.objectBegin(at, {"o"});
            state.objectInstance(at, {"o"});
            state.objectEnd(at);
        }
        EXPECT_EQ(errors(), before);
        state.objectBegin(at, {"p"});
        state.objectInstance(at, {"o"});
        state.objectEnd(at);
        EXPECT_EQ(errors(), before + 1);
    }
    EXPECT_TRUE(says("nested more than 64 deep"));
}

// Those of the file belong to every world, those of a frame or a world end with it.
TEST_F(State, objectsLiveAsLongAsTheBlockAroundThem) {
    state.objectBegin(at, {"file"});
    state.translate(at, 0, 2, 0);
    sphere();
    state.objectEnd(at);
    for (int frame = 0; frame < 2; ++frame) {
        state.frameBegin(at, frame);
        state.objectInstance(at, {"file"});
        EXPECT_EQ(errors(), 4 * frame + 1); // Legal in worlds and definitions alone.
        state.objectBegin(at, {"frame"});
        state.objectInstance(at, {"file"});
        state.objectEnd(at);
        for (int world = 0; world < 2; ++world) {
            state.worldBegin(at);
            state.objectInstance(at, {"world"});
            state.objectBegin(at, {"world"});
            sphere();
            sphere();
            state.objectEnd(at);
            for (const char *handle : {"file", "frame", "world"})
                state.objectInstance(at, {handle});
            state.worldEnd(at);
            const auto &said = builder.worlds.back();
            ASSERT_EQ(said.objects.size(), 3u);
            EXPECT_EQ(said.objects.at(0).primitives[0].place(0, 0, 0), (Vec3{0, 2, 0}));
            EXPECT_EQ(said.objects.at(1).instances[0].object, 0);
            EXPECT_EQ(said.objects.at(2).primitives.size(), 2u);
            ASSERT_EQ(said.instances.size(), 3u);
            for (int i = 0; i < 3; ++i)
                EXPECT_EQ(said.instances[i].object, i);
        }
        state.frameEnd(at);
        state.worldBegin(at);
        state.objectInstance(at, {"frame"});
        state.worldEnd(at);
        EXPECT_EQ(builder.worlds.back().objects.size(), 1u);
        EXPECT_EQ(errors(), 4 * (frame + 1));
    }
}

TEST_F(State, blocksInObjectsMatch) {
    state.worldBegin(at);
    state.attributeBegin(at);
    state.objectEnd(at);
    EXPECT_EQ(errors(), 1);
    state.objectBegin(at, {"o"});
    state.attributeEnd(at); // Does not reach out of the object.
    EXPECT_EQ(errors(), 2);
    state.objectBegin(at, {"p"}); // Definitions do not nest.
    EXPECT_TRUE(says("ObjectBegin"));
    state.attributeBegin(at);
    state.translate(at, 1, 0, 0);
    sphere();
    const int before = errors();
    state.objectEnd(at); // Closes the block inside.
    EXPECT_EQ(errors(), before + 1);
    state.objectInstance(at, {"o"});
    sphere();
    state.attributeEnd(at);
    state.objectBegin(at, {"q"});
    state.worldEnd(at); // Closes the object.
    EXPECT_EQ(errors(), before + 2);
    const auto &world = builder.worlds.back();
    EXPECT_EQ(world.openObject, -1);
    EXPECT_EQ(world.objects.at(0).primitives.size(), 1u);
    EXPECT_EQ(world.instances.size(), 1u);
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{0, 0, 0}));
}

// Objects of objects stand for more than any memory holds and are told in a few calls. Those that
// hold nothing count as well: someone has to look into them.
TEST_F(State, instancesOfMoreThanMemoryHoldsAreLeftOut) {
    struct Case {
        int levels, copies;    // Objects, and how many of the one before each holds.
        bool hollow, inWorld;  // No primitive in it; defined inside the world.
        int instances, placed; // Of the last object: asked for, drawn.
    };
    const Case cases[] = {
        {1, 0, false, true, 3, 3},     {23, 2, false, true, 1, 1}, {23, 2, false, false, 3, 1},
        {24, 2, false, true, 1, 0},    {40, 2, false, true, 2, 0}, {60, 2, true, true, 1, 0},
        {64, 1, true, true, 100, 100}, {8, 10, false, true, 2, 1}, {64, 1000, false, false, 2, 0},
        {3, 4000, false, false, 1, 0},
    };
    for (const Case &c : cases) {
        SCOPED_TRACE(std::to_string(c.levels) + " levels of " + std::to_string(c.copies));
        const int before = errors();
        const auto define = [&] {
            for (int i = 0; i < c.levels; ++i) {
                state.objectBegin(at, {std::to_string(i)});
                if (!c.hollow)
                    sphere();
                for (int copy = 0; copy < c.copies && i > 0; ++copy)
                    state.objectInstance(at, {std::to_string(i - 1)});
                state.objectEnd(at);
            }
        };
        if (!c.inWorld)
            define();
        for (int world = 0; world < 2; ++world) { // Each counts for itself.
            state.worldBegin(at);
            if (c.inWorld)
                define();
            for (int i = 0; i < c.instances; ++i)
                state.objectInstance(at, {std::to_string(c.levels - 1)});
            EXPECT_EQ(builder.worlds.back().instances.size(), std::size_t(c.placed));
            state.worldEnd(at);
        }
        EXPECT_EQ(errors() - before, 2 * (c.instances - c.placed));
        EXPECT_TRUE(c.instances == c.placed || says("more than 16000000"));
    }
}

TEST_F(State, instancesShareTheirAttributes) {
    state.objectBegin(at, {"o"});
    sphere();
    state.objectEnd(at);
    state.worldBegin(at);
    state.color(at, Color(0, 1, 0));
    for (int i = 0; i < 10000; ++i) {
        state.attributeBegin(at);
        state.translate(at, float(i), 0, 0);
        state.scale(at, i % 2 ? -1.f : 1.f, 1, 1);
        state.objectInstance(at, {"o"});
        state.attributeEnd(at);
    }
    const auto &instances = builder.worlds.back().instances;
    ASSERT_EQ(instances.size(), 10000u);
    for (const auto &instance : instances)
        EXPECT_EQ(instance.attributes, instances[0].attributes);
}

} // namespace candela::testing
