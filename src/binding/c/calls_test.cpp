// SPDX-License-Identifier: Apache-2.0
// Calls of ri.h: each writes its request, in both forms, with as many values as its types and its
// primitive say.
#include "ri.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace candela::c {
namespace {

std::vector<std::string> heard;
void hear(RtInt, RtInt, char *message) { heard.push_back(message); }

/// The RIB that the calls write, without its first line.
std::string ribOf(const std::function<void()> &calls) {
    const std::string file =
        std::string(CANDELA_BINARY_DIR) + "/calls_test." + std::to_string(::getpid()) + ".rib";
    heard.clear();
    RiErrorHandler(hear);
    RiBegin(file.c_str());
    calls();
    RiEnd();
    std::ifstream in(file);
    std::string text{std::istreambuf_iterator<char>(in), {}};
    std::filesystem::remove(file);
    return text.substr(std::min(text.find('\n') + 1, text.size()));
}

RtFloat numbers[64] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15,
                       16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
RtToken token = "varying float x";

/// "[0 1 2]"
std::string list(int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += (i ? " " : "") + std::to_string(int(numbers[i]));
    return "[" + text + "]";
}

TEST(Calls, writeTheirRequests) {
    RtColor red = {1, 0, .5f};
    RtMatrix matrix = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 2, 3, 1}};
    RtBasis own = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
    RtBound box = {0, 1, 2, 3, 4, 5};
    RtFloat one = 1;
    RtInt four[] = {4}, wide[] = {16777217, -2147483647};
    RtString calm[] = {"calm"};
    const struct {
        std::function<void()> call;
        const char *rib;
    } cases[] = {
        {[] { RiFormat(640, 480, 1); }, "Format 640 480 1"},
        {[] { RiCropWindow(0, .5f, 0, 1); }, "CropWindow 0 0.5 0 1"},
        {[&] { RiProjection(RI_PERSPECTIVE, RI_FOV, &one, RI_NULL); },
         "Projection \"perspective\" \"fov\" [1]"},
        {[] { RiDepthOfField(2.8f, .05f, 4); }, "DepthOfField 2.8 0.05 4"},
        {[] { RiPixelFilter(RiSincFilter, 4, 4); }, "PixelFilter \"sinc\" 4 4"},
        {[] { RiQuantize(RI_RGBA, 255, 0, 255, .5f); }, "Quantize \"rgba\" 255 0 255 0.5"},
        {[] { RiDisplay("a.exr", RI_FILE, RI_RGB, RI_NULL); },
         "Display \"a.exr\" \"file\" \"rgb\""},
        {[&] { RiOption("trace", "integer maxdepth", four, RI_NULL); },
         "Option \"trace\" \"integer maxdepth\" [4]"},
        {[&] { RiAttribute("user", "integer[2] ids", wide, RI_NULL); },
         "Attribute \"user\" \"integer[2] ids\" [16777217 -2147483647]"},
        {[&] { RiAttribute("user", "string mood", calm, RI_NULL); },
         "Attribute \"user\" \"string mood\" [\"calm\"]"},
        {[&] { RiColor(red), RiOpacity(red); }, "Color [1 0 0.5]\nOpacity [1 0 0.5]"},
        {[] { RiMatte(RI_TRUE); }, "Matte 1"},
        {[&] { RiBound(box); }, "Bound 0 1 2 3 4 5"},
        {[&] { RiSurface("plastic", "Kd", &one, "float[2] pair", numbers, RI_NULL); },
         "Surface \"plastic\" \"Kd\" [1] \"float[2] pair\" [0 1]"},
        {[&] { RiBasis(RiBSplineBasis, RI_BSPLINESTEP, own, 2); },
         "Basis \"b-spline\" 1 [1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16] 2"},
        {[&] { RiConcatTransform(matrix); }, "ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 1 2 3 1]"},
        {[] { RiSkew(1, 2, 3, 4, 5, 6, 7); }, "Skew 1 2 3 4 5 6 7"},
        {[] {
             RiMotionBegin(2, 0., .5), RiTranslate(0, 0, 1), RiTranslate(0, 0, 2), RiMotionEnd();
         },
         "MotionBegin [0 0.5]\n  Translate 0 0 1\n  Translate 0 0 2\nMotionEnd"},
        {[] { RiIlluminate(RiLightSource("ambientlight", RI_NULL), RI_FALSE); },
         "LightSource \"ambientlight\" 1\nIlluminate 1 0"},
        {[] {
             RtObjectHandle object = RiObjectBegin();
             RiObjectEnd();
             RiObjectInstance(object);
         },
         "ObjectBegin 1\nObjectEnd\nObjectInstance 1"},
        {[] { RiIlluminate(RiLight("PxrRectLight", "key", RI_NULL), RI_TRUE); },
         "Light \"PxrRectLight\" \"key\"\nIlluminate \"key\" 1"},
        {[] { RiPushFilter("bloom", RI_NULL), RiPopFilter(); }, "PushFilter \"bloom\"\nPopFilter"},
        {[] { RiBxdf("PxrDiffuse", "skin", RI_NULL); }, "Bxdf \"PxrDiffuse\" \"skin\""},
        {[&] {
             static RtInt dimensions[] = {1, 2, 2};
             RiVolume("box", box, dimensions, token, numbers, RI_NULL);
         },
         "Volume \"box\" [0 1 2 3 4 5] [1 2 2] \"varying float x\" [0 1 2 3]"},
        {[] {
             static RtInt three[] = {3}, corners[] = {0, 1, 2}, counts[] = {1, 2, 1}, face[] = {0};
             static RtToken tags[] = {"faceedit"}, words[] = {"attributes"};
             RiHierarchicalSubdivisionMesh(RI_CATMULLCLARK, 1, three, corners, 1, tags, counts,
                                           face, numbers, words, RI_NULL);
         },
         "HierarchicalSubdivisionMesh \"catmull-clark\" [3] [0 1 2] [\"faceedit\"] [1 2 1] [0] "
         "[0 1] [\"attributes\"]"},
        {[] { RiIfBegin("$x", RI_NULL), RiElse(), RiIfEnd(); }, "IfBegin \"$x\"\nElse\nIfEnd"},
        {[] { RiArchiveBegin("a", RI_NULL), RiArchiveEnd(), RiReadArchive("a", nullptr, RI_NULL); },
         "ArchiveBegin \"a\"\nArchiveEnd\nReadArchive \"a\""},
        {[] {
             RiArchiveRecord(RI_COMMENT, "%d%%", 5), RiArchiveRecord(RI_STRUCTURE, "Scene");
             RiArchiveRecord(RI_VERBATIM, "Sides %d\n", 1);
         },
         "# 5%\n##Scene\nSides 1"},
        {[] { RiMakeShadow("a", "b", RI_NULL); }, "MakeShadow \"a\" \"b\""},
        {[] { RiMakeTexture("a", "b", RI_PERIODIC, RI_CLAMP, RiBoxFilter, 1, 1, RI_NULL); },
         "MakeTexture \"a\" \"b\" \"periodic\" \"clamp\" \"box\" 1 1"},
        {[] { RiGeometry("teapot", RI_NULL); }, "Geometry \"teapot\""},
        {[] {
             static RtString name[] = {"a.rib"};
             static RtBound bound = {0, 1, 0, 1, 0, 1};
             RiProcedural(name, bound, RiProcDelayedReadArchive, nullptr);
         },
         "Procedural \"DelayedReadArchive\" [\"a.rib\"] [0 1 0 1 0 1]"},
    };
    for (const auto &each : cases) {
        EXPECT_EQ(ribOf(each.call), std::string(each.rib) + "\n");
        EXPECT_TRUE(heard.empty()) << each.rib << ": " << heard.front();
    }
}

// RI 3.2, section 5: how many values a varying, uniform and vertex variable has.
TEST(Calls, readAsManyValuesAsThePrimitiveHas) {
    static RtInt three[] = {3, 3}, loops[] = {1, 1}, corners[] = {0, 1, 2, 1, 2, 3},
                 five[] = {5, 4};
    const auto counts = [](const std::function<void(RtToken, RtPointer)> &primitive) {
        std::vector<int> result;
        for (const char *storage : {"uniform", "varying", "vertex"}) {
            const std::string name = std::string(storage) + " float x";
            const std::string rib = ribOf([&] { primitive(name.c_str(), numbers); });
            const std::size_t begin = rib.rfind('[') + 1;
            std::istringstream values(rib.substr(begin, rib.rfind(']') - begin));
            result.push_back(int(std::distance(std::istream_iterator<std::string>(values), {})));
        }
        return result;
    };
    using Counts = std::vector<int>;
    const auto polygons = [&](RtToken t, RtPointer v) {
        RiPointsPolygons(2, three, corners, t, v, RI_NULL);
    };
    EXPECT_EQ(counts([](auto t, auto v) { RiSphere(1, -1, 1, 360, t, v, RI_NULL); }),
              (Counts{1, 4, 4}));
    EXPECT_EQ(counts([](auto t, auto v) { RiDiskV(0, 1, 360, 1, &t, &v); }), (Counts{1, 4, 4}));
    EXPECT_EQ(counts([](auto t, auto v) { RiPolygon(5, t, v, RI_NULL); }), (Counts{1, 5, 5}));
    EXPECT_EQ(counts([&](auto t, auto v) { RiGeneralPolygon(2, three, t, v, RI_NULL); }),
              (Counts{1, 6, 6}));
    EXPECT_EQ(counts(polygons), (Counts{2, 4, 4}));
    EXPECT_EQ(counts([&](auto t, auto v) {
                  RiPointsGeneralPolygons(2, loops, three, corners, t, v, RI_NULL);
              }),
              (Counts{2, 4, 4}));
    EXPECT_EQ(counts([](auto t, auto v) { RiPatch(RI_BILINEAR, t, v, RI_NULL); }),
              (Counts{1, 4, 4}));
    EXPECT_EQ(counts([](auto t, auto v) { RiPatch(RI_BICUBIC, t, v, RI_NULL); }),
              (Counts{1, 4, 16}));
    EXPECT_EQ(counts([](auto t, auto v) {
                  RiPatchMesh(RI_BICUBIC, 7, RI_NONPERIODIC, 4, RI_NONPERIODIC, t, v, RI_NULL);
              }),
              (Counts{2, 6, 28}));
    EXPECT_EQ(counts([](auto t, auto v) {
                  RiAttributeBegin();
                  RiBasis(RiBSplineBasis, 1, RiBSplineBasis, 1);
                  RiPatchMesh(RI_BICUBIC, 6, RI_PERIODIC, 4, RI_NONPERIODIC, t, v, RI_NULL);
                  RiAttributeEnd();
              }),
              (Counts{6, 12, 24}));
    EXPECT_EQ(counts([](auto t, auto v) { // The step of the block is gone.
                  RiAttributeBegin();
                  RiBasis(RiBSplineBasis, 1, RiBSplineBasis, 1);
                  RiAttributeEnd();
                  RiPatchMesh(RI_BICUBIC, 7, RI_NONPERIODIC, 4, RI_NONPERIODIC, t, v, RI_NULL);
              }),
              (Counts{2, 6, 28}));
    EXPECT_EQ(counts([](auto t, auto v) {
                  RiNuPatch(4, 3, numbers, 0, 1, 3, 2, numbers, 0, 1, t, v, RI_NULL);
              }),
              (Counts{4, 9, 12}));
    EXPECT_EQ(counts([&](auto t, auto v) {
                  RiSubdivisionMesh(RI_CATMULLCLARK, 2, three, corners, 0, nullptr, nullptr,
                                    nullptr, nullptr, t, v, RI_NULL);
              }),
              (Counts{2, 4, 4}));
    EXPECT_EQ(counts([](auto t, auto v) { RiPoints(7, t, v, RI_NULL); }), (Counts{1, 7, 7}));
    EXPECT_EQ(counts([&](auto t, auto v) {
                  RiCurves(RI_LINEAR, 2, five, RI_NONPERIODIC, t, v, RI_NULL);
              }),
              (Counts{2, 9, 9}));
    EXPECT_EQ(counts([&](auto t, auto v) {
                  RiBasis(RiBezierBasis, 3, RiCatmullRomBasis, 1);
                  RiCurves(RI_CUBIC, 2, five, RI_NONPERIODIC, t, v, RI_NULL);
              }),
              (Counts{2, 5, 9}));
}

TEST(Calls, typesSayWhatPointersLeadTo) {
    RtInt whole[] = {7, 8, 9, 10};
    RtString texts[] = {"a", "b"};
    const std::string rib = ribOf([&] {
        RiDeclare("tint", "uniform color");
        RiDeclare("names", "constant string[2]");
        RiPoints(2, "tint", numbers, "varying integer i", whole, "names", texts, "P", numbers,
                 RI_NULL);
    });
    EXPECT_EQ(rib, "Declare \"tint\" \"uniform color\"\n"
                   "Declare \"names\" \"constant string[2]\"\n"
                   "Points \"tint\" " +
                       list(3) +
                       " \"varying integer i\" [7 8] \"names\" [\"a\" \"b\"] "
                       "\"P\" " +
                       list(6) + "\n");
    EXPECT_TRUE(heard.empty());
}

TEST(Calls, whatIsWrongIsToldToTheHandler) {
    EXPECT_EQ(ribOf([] { RiSphere(1, -1, 1, 360, "mystery", numbers, token, numbers, RI_NULL); }),
              "Sphere 1 -1 1 360 \"varying float x\" " + list(4) + "\n");
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_NE(heard[0].find("RiSphere: parameter 'mystery' has not been declared"),
              std::string::npos)
        << heard[0];
    EXPECT_EQ(RiLastError, RIE_CONSISTENCY);
    EXPECT_EQ(ribOf([] {
                  RiSphere(1, -1, 1, 360, token, nullptr, RI_NULL);
                  RiPatchMesh(RI_BICUBIC, 5, RI_NONPERIODIC, 4, RI_NONPERIODIC, token, numbers,
                              RI_NULL);
                  RiPolygon(-3, token, numbers, RI_NULL);
                  RiPointsPolygons(1, nullptr, nullptr, RI_NULL);
                  RiSurface(nullptr, RI_NULL);
                  RiArchiveRecord("secret", "x");
                  RiPixelFilter(nullptr, 1, 1);
              }),
              "Sphere 1 -1 1 360\n"
              "PatchMesh \"bicubic\" 5 \"nonperiodic\" 4 \"nonperiodic\" \"varying float x\" []\n"
              "Polygon \"varying float x\" []\nPointsPolygons [] []\nSurface \"\"\n"
              "PixelFilter \"gaussian\" 1 1\n");
    EXPECT_EQ(heard.size(), 3u);
    heard.clear();
    RiSides(1), RiSides(1);
    ASSERT_EQ(heard.size(), 1u); // Once.
    EXPECT_NE(heard[0].find("RiSides: there is no context"), std::string::npos);
    EXPECT_EQ(RiLastError, RIE_NOTSTARTED);
}

TEST(Calls, goToTheContextThatIsCurrent) {
    std::string inner;
    const std::string outer = ribOf([&] {
        RiSides(1);
        const RtContextHandle first = RiGetContext();
        inner = ribOf([] { RiSides(2); });
        EXPECT_EQ(RiGetContext(), nullptr);
        RiContext(first);
        RiMatte(1);
    });
    EXPECT_EQ(outer, "");
    EXPECT_EQ(inner, "Sides 2\n");
}

// A program's own procedural may do what it likes to attributes.
TEST(Calls, proceduralsAreCalledAndTheirDataFreed) {
    static RtFloat asked = 0;
    static bool freed = false;
    RtBound bound = {0, 1, 0, 1, 0, 1};
    const std::string rib = ribOf([&] {
        RiProcedural(
            numbers, bound,
            [](RtPointer data, RtFloat detail) {
                asked = detail;
                RiSides(int(static_cast<RtFloat *>(data)[1]));
            },
            [](RtPointer data) { freed = data == numbers; });
    });
    EXPECT_EQ(rib, "AttributeBegin\n  Sides 1\nAttributeEnd\n");
    EXPECT_TRUE(freed);
    EXPECT_EQ(asked, 0); // RIB that is written has no camera.
}

/// The calls in a world of a context that renders nothing.
void inWorld(const std::function<void()> &calls) {
    heard.clear();
    RiErrorHandler(hear);
    RiBegin(RI_NULL);
    RiHider("null", RI_NULL);
    RiTranslate(0, 0, 5);
    RiWorldBegin();
    calls();
    RiWorldEnd();
    RiEnd();
}

TEST(Calls, transformPointsFromSystemToSystem) {
    using Points = std::array<std::array<float, 3>, 2>;
    const auto transformed = [](RtToken from, RtToken to) {
        RtPoint points[] = {{0, 0, 0}, {1, 0, 0}};
        const RtPoint *result = RiTransformPoints(from, to, 2, points);
        EXPECT_EQ(result, heard.empty() ? points : nullptr) << from << " to " << to;
        Points all;
        for (std::size_t i = 0; i < 6; ++i) // Of sines and cosines, to a millionth.
            all[i / 3][i % 3] = std::round(1e6f * points[i / 3][i % 3]) / 1e6f + 0.f;
        return all;
    };
    inWorld([&] {
        RiTranslate(1, 2, 3);
        RiScale(2, 2, 2);
        RiCoordinateSystem("desk");
        RiRotate(90, 0, 0, 1);
        EXPECT_EQ(transformed("desk", "world"), (Points{{{1, 2, 3}, {3, 2, 3}}}));
        EXPECT_EQ(transformed("world", "camera"), (Points{{{0, 0, 5}, {1, 0, 5}}}));
        EXPECT_EQ(transformed("current", "desk"), (Points{{{0, 0, 0}, {0, 1, 0}}}));
        EXPECT_EQ(transformed("camera", "desk"), (Points{{{-.5f, -1, -4}, {0, -1, -4}}}));
        EXPECT_TRUE(heard.empty());
        for (const auto &[from, to] : {std::pair{"nowhere", "world"}, {"world", "nowhere"}}) {
            heard.clear();
            heard.push_back("");
            EXPECT_EQ(transformed(from, to), (Points{{{0, 0, 0}, {1, 0, 0}}}));
            ASSERT_EQ(heard.size(), 2u);
            EXPECT_NE(heard[1].find("'nowhere' is known here"), std::string::npos) << heard[1];
        }
    });
}

std::vector<std::string> told;
void listen(RtToken type, char *format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    EXPECT_STREQ(format, "%s");
    told.push_back(std::string(type) + ":" + va_arg(arguments, const char *));
    va_end(arguments);
}

TEST(Calls, readArchivesAndHearTheirComments) {
    const std::string file =
        std::string(CANDELA_BINARY_DIR) + "/heard." + std::to_string(::getpid()) + ".rib";
    std::ofstream(file)
        << "# a comment\n##Structure\nTranslate 1 0 0\nCoordinateSystem \"there\"\n";
    told.clear();
    RtPoint point[] = {{0, 0, 0}};
    inWorld([&] {
        RiReadArchive(file.c_str(), listen, RI_NULL);
        EXPECT_TRUE(RiTransformPoints("there", "world", 1, point));
    });
    std::filesystem::remove(file);
    EXPECT_TRUE(heard.empty()) << heard.front();
    EXPECT_EQ(told, (std::vector<std::string>{"comment: a comment", "structure:Structure"}));
    EXPECT_EQ(point[0][0], 1);
}

} // namespace
} // namespace candela::c
