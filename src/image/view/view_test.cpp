// SPDX-License-Identifier: Apache-2.0
// What is seen of pictures, after which keys and moves of the mouse: without a window.
#include "image/view/view.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

using Kind = ViewEvent::Kind;

Picture pictureOf(int columns, int rows, std::vector<PictureChannel> channels) {
    Picture picture;
    picture.window = {columns, rows, 0, columns, 0, rows};
    picture.channels = std::move(channels);
    picture.metadata["units"] = "W m^-2 sr^-1";
    return picture;
}

/// Two pixels: red of 1 and white of a quarter.
Picture twoPixels() {
    return pictureOf(2, 1,
                     {{"R", {1, .25f}},
                      {"G", {0, .25f}},
                      {"B", {0, .25f}},
                      {"A", {1, .5f}},
                      {"Z", {2, 4}},
                      {"N.X", {0, 1}},
                      {"N.Y", {1, 0}},
                      {"N.Z", {0, 0}}});
}

void press(View &view, const std::string &keys) {
    for (const char key : keys)
        view.handle({Kind::Key, 0, 0, std::string(1, key)});
}

/// Of a window of 2 x 1 pixels, unless it has been made larger.
View viewOf(Picture picture) {
    View view;
    view.handle({Kind::Resize, picture.window.columns(), picture.window.rows()});
    view.show("seen", std::move(picture), true);
    return view;
}

using Pixels = std::vector<std::uint32_t>;

TEST(View, layersAreWhatIsLookedAtTogether) {
    struct Expected {
        std::string name;
        std::size_t channels;
        bool hasAlpha, isLight;
    } expected[] = {{"color", 3, true, true}, {"Z", 1, false, false}, {"N", 3, false, false}};
    const auto layers = layersOf(twoPixels());
    ASSERT_EQ(layers.size(), std::size(expected));
    for (std::size_t k = 0; k < layers.size(); ++k) {
        EXPECT_EQ(layers[k].name, expected[k].name);
        EXPECT_EQ(layers[k].channels.size(), expected[k].channels) << layers[k].name;
        EXPECT_EQ(layers[k].alpha >= 0, expected[k].hasAlpha) << layers[k].name;
        EXPECT_EQ(layers[k].isLight, expected[k].isLight) << layers[k].name;
    }
    const auto namesOf = [](const std::vector<std::string> &channels) {
        std::vector<PictureChannel> all;
        for (const std::string &name : channels)
            all.push_back({name, {0}});
        std::string names;
        for (const ViewLayer &layer : layersOf(pictureOf(1, 1, all)))
            names += layer.name + " ";
        return names;
    };
    EXPECT_EQ(namesOf({"A", "B", "G", "R"}), "color "); // As EXR files have them.
    EXPECT_EQ(namesOf({"A"}), "A ");
    EXPECT_EQ(namesOf({"Y", "A"}), "Y A ");
    EXPECT_EQ(namesOf({"albedo.B", "albedo.G", "albedo.R", "id"}), "albedo id ");
    EXPECT_EQ(namesOf({"x.R", "x.G"}), "x.R x.G ");
    EXPECT_EQ(namesOf({}), "");
}

TEST(View, keysChooseExposureAndChannel) {
    // sRGB: 1 is 255, 1/2 188, 1/4 137, 1/8 99.
    const struct {
        std::string keys;
        Pixels pixels;
    } cases[] = {
        {"", {0xff0000, 0x898989}},    {"++", {0xff0000, 0xbcbcbc}}, {"--", {0xbc0000, 0x636363}},
        {"--0", {0xff0000, 0x898989}}, {"r", {0xffffff, 0x898989}},  {"g", {0x000000, 0x898989}},
        {"b", {0x000000, 0x898989}},   {"rr", {0xff0000, 0x898989}}, {"rg", {0x000000, 0x898989}},
        {"a", {0xffffff, 0x808080}},   {"l", {0x7f7f7f, 0x898989}}, // .2126
        {"k", {0xff0000, 0x898989}},                                // No key.
    };
    for (const auto &each : cases) {
        View view = viewOf(twoPixels());
        press(view, each.keys);
        EXPECT_EQ(view.paint(), each.pixels) << each.keys;
    }
}

TEST(View, pagesLeadThroughAllLayersOfAllDisplays) {
    View view = viewOf(twoPixels());
    view.show("other", pictureOf(2, 1, {{"id", {0, 3}}}), false);
    const auto turned = [&](const char *key) {
        view.handle({Kind::Key, 0, 0, key});
        const std::string title = view.title();
        return title.substr(0, title.find(','));
    };
    for (const char *title :
         {"seen: Z", "seen: N", "other (in the making): id", "seen: color", "seen: Z"})
        EXPECT_EQ(turned("page down"), title);
    for (const char *title : {"seen: color", "other (in the making): id", "seen: N"})
        EXPECT_EQ(turned("page up"), title);
    turned("page up");
    EXPECT_EQ(view.paint(), (Pixels{0xbcbcbc, 0xffffff})); // Depths 2 and 4: the largest is white.
}

TEST(View, aNewerPictureTakesThePlaceOfTheLast) {
    View view = viewOf(twoPixels());
    press(view, "++");
    Picture black = twoPixels();
    for (PictureChannel &channel : black.channels)
        channel.values = {0, 0};
    view.show("seen", black, true);
    EXPECT_EQ(view.paint(), (Pixels{0, 0}));
    EXPECT_EQ(view.title(), "seen: color, +1 stops");
    view.show("seen", pictureOf(1, 1, {{"R", {1}}}), true); // With fewer layers, of another size.
    EXPECT_EQ(view.paint(), (Pixels{0xffffff, 0x202020}));
}

TEST(View, thePictureFitsUntilItIsMovedAndZoomed) {
    View view = viewOf(twoPixels());
    view.handle({Kind::Resize, 4, 4}); // Twice as large, in the middle.
    const std::uint32_t o = 0x202020, r = 0xff0000, g = 0x898989;
    EXPECT_EQ(view.paint(), (Pixels{o, o, o, o, r, r, g, g, r, r, g, g, o, o, o, o}));
    view.handle({Kind::Drag, 2, -1});
    EXPECT_EQ(view.paint(), (Pixels{o, o, r, r, o, o, r, r, o, o, o, o, o, o, o, o}));
    press(view, "f");
    EXPECT_EQ(view.paint(), (Pixels{o, o, o, o, r, r, g, g, r, r, g, g, o, o, o, o}));
    view.handle({Kind::Pointer, 3, 1});
    view.handle({Kind::Wheel, 0, 2}); // Twice as large, with what is under the pointer there.
    EXPECT_EQ(view.paint()[1 * 4 + 3], g);
    EXPECT_EQ(view.paint()[1 * 4 + 0], r); // One pixel is four wide.
    press(view, "1");
    EXPECT_EQ(std::ranges::count(view.paint(), r) + std::ranges::count(view.paint(), g), 2);
    for (int i = 0; i < 100; ++i) // It ends somewhere.
        press(view, "z");
    for (int i = 0; i < 200; ++i)
        press(view, "x");
    EXPECT_EQ(view.paint().size(), 16u);
}

TEST(View, theTitleTellsWhatIsUnderThePointer) {
    Picture picture = twoPixels();
    picture.window = {20, 20, 10, 12, 7, 8}; // A crop.
    View view;
    EXPECT_EQ(view.title(), "candela");
    view.handle({Kind::Resize, 2, 1});
    view.show("seen", picture, true);
    EXPECT_EQ(view.title(), "seen: color");
    view.handle({Kind::Pointer, 1, 0});
    EXPECT_EQ(view.title(), "seen: color, (11, 7) R 0.25 G 0.25 B 0.25 A 0.5 W m^-2 sr^-1, "
                            "44.75 cd/m^2"); // 179 lm/W
    view.handle({Kind::Key, 0, 0, "page down"});
    EXPECT_EQ(view.title(), "seen: Z, (11, 7) Z 4");
    view.handle({Kind::Key, 0, 0, "page down"});
    EXPECT_EQ(view.title(), "seen: N, (11, 7) X 1 Y 0 Z 0");
    view.handle({Kind::Pointer, 5, 0});
    EXPECT_EQ(view.title(), "seen: N");
    picture.metadata["units"] = "relative"; // Light without units is told without.
    View other = viewOf(picture);
    other.handle({Kind::Pointer, 1, 0});
    EXPECT_EQ(other.title(), "seen: color, (11, 7) R 0.25 G 0.25 B 0.25 A 0.5");
}

TEST(View, displayValuesAreShownAsTheyAre) {
    Picture picture = pictureOf(2, 1, {{"R", {1, .5f}}, {"G", {0, .5f}}, {"B", {0, .5f}}});
    picture.hasDisplayValues = true;
    View view = viewOf(picture);
    EXPECT_EQ(view.paint(), (Pixels{0xff0000, 0x808080}));
    view.handle({Kind::Pointer, 1, 0});
    EXPECT_EQ(view.title(), "seen: color, (1, 0) R 0.5 G 0.5 B 0.5");
}

// What Exposure has put on a curve is not put on another one, and is the light that it was.
TEST(View, exposureIsKnown) {
    const float value = std::pow(2 * .25f, 1 / 2.2f);
    Picture picture = pictureOf(1, 1, {{"R", {value}}, {"G", {value}}, {"B", {value}}});
    picture.metadata["exposure"] = "2 2.2";
    View view = viewOf(picture);
    EXPECT_EQ(view.paint(), (Pixels{0xbcbcbc})); // A half, on the curve of sRGB.
    view.handle({Kind::Pointer, 0, 0});
    EXPECT_EQ(view.title(), "seen: color, (0, 0) R 0.7297 G 0.7297 B 0.7297, 44.75 cd/m^2");
    picture.metadata["filters"] = "ward94"; // Whatever that has made of it, light it is not.
    view.show("seen", picture, true);
    EXPECT_EQ(view.title(), "seen: color, (0, 0) R 0.7297 G 0.7297 B 0.7297");
    picture.metadata["exposure"] = "-1 fast";
    view.show("seen", picture, true);
    EXPECT_EQ(view.paint(), (Pixels{0xdedede})); // 255 (1.055 x .7297^(1 / 2.4) - .055)
}

TEST(View, strangeValuesAndPicturesAreShownToo) {
    const float nan = std::nanf(""), inf = INFINITY;
    View view = viewOf(pictureOf(4, 1, {{"Z", {nan, inf, 3e38f, -1}}}));
    EXPECT_EQ(view.paint(), (Pixels{0, 0xffffff, 0xffffff, 0xffffff}));
    view.show("none", pictureOf(2, 2, {}), true);
    view.show("empty", pictureOf(0, 0, {{"Z", {}}}), true);
    view.handle({Kind::Key, 0, 0, "page down"});
    EXPECT_EQ(view.paint(), (Pixels(4, 0x202020)));
}

TEST(View, isClosedByItsKeysAndByTheWindow) {
    for (const ViewEvent &event : {ViewEvent{Kind::Key, 0, 0, "q"},
                                   ViewEvent{Kind::Key, 0, 0, "escape"}, ViewEvent{Kind::Close}}) {
        View view = viewOf(twoPixels());
        EXPECT_FALSE(view.isClosed());
        view.handle(event);
        EXPECT_TRUE(view.isClosed());
    }
}

} // namespace
} // namespace candela
