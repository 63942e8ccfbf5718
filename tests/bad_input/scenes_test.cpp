// SPDX-License-Identifier: Apache-2.0
// What can be wrong inside a RIB file: said with file and line, and the rest is rendered.
#include "tests/bad_input/bad_input.h"

namespace candela::test {

// The scene itself must be all right, or the other tests say nothing.
TEST_F(BadInput, NothingWrong) {
    Outcome run = render(sceneWith("Color 1 0 0"));
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(run.err, "");
    expectDisc();
}

TEST_F(BadInput, UnknownRequest) {
    expectErrorAtTheLine("Frobnicate 1 2 \"string x\" [\"y\"]", {"Frobnicate"});
}

TEST_F(BadInput, TooFewArguments) {
    expectErrorAtTheLine("Sphere 1 -1 360 Color 1 1 1", {"Sphere"});
}

TEST_F(BadInput, TooManyArguments) { expectErrorAtTheLine("Translate 1 2 3 4", {"Translate"}); }

TEST_F(BadInput, WrongTypeOfArgument) {
    expectErrorAtTheLine("Sphere \"big\" -1 1 360", {"Sphere"});
}

TEST_F(BadInput, WrongTypeOfParameter) {
    expectErrorAtTheLine("Polygon \"P\" [\"a\" \"b\"]", {"P"});
}

TEST_F(BadInput, WrongNumberOfValues) {
    expectErrorAtTheLine("Polygon \"P\" [0 0 3 1 0 3 1 1]", {"P"});
}

TEST_F(BadInput, IndexBeyondThePoints) {
    expectErrorAtTheLine("PointsPolygons [3] [0 1 7] \"P\" [0 0 3 1 0 3 0 1 3]",
                         {"PointsPolygons"});
}

TEST_F(BadInput, UnmatchedEnd) { expectErrorAtTheLine("TransformEnd", {"TransformEnd"}); }

// The string takes everything up to the end of the file with it: what came before is rendered.
TEST_F(BadInput, UnterminatedString) {
    std::string rib = sceneWith("Color 1 1 1");
    rib.insert(rib.find("WorldEnd"), "Attribute \"identifier\" \"string name\" [\"no end\n");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("scene.rib:13")) << run.text();
    EXPECT_TRUE(run.says("string")) << run.text();
    expectDisc();
}

TEST_F(BadInput, MissingShader) {
    expectErrorAtTheLine("Surface \"nosuchshader\"\nTranslate 9 0 5 Sphere 1 -1 1 360",
                         {"nosuchshader"});
}

TEST_F(BadInput, MissingLightShader) {
    expectErrorAtTheLine("LightSource \"nosuchlight\" 1", {"nosuchlight"});
}

TEST_F(BadInput, MissingArchive) {
    expectErrorAtTheLine("ReadArchive \"nosuch.rib\"", {"nosuch.rib"});
}

TEST_F(BadInput, ErrorInsideAnArchiveHasItsOwnPlace) {
    folder_.write("part.rib", "# first\nNonsense 1\nSphere .1 -.1 .1 360\n");
    expectReportedAndRendered("Translate 9 0 5 ReadArchive \"part.rib\"",
                              {"part.rib:2", "Nonsense"});
}

TEST_F(BadInput, ArchiveThatReadsItself) {
    folder_.write("loop.rib", "ReadArchive \"loop.rib\"\n");
    expectReportedAndRendered("ReadArchive \"loop.rib\"", {"loop.rib:1"});
}

TEST_F(BadInput, DegenerateSphere) { expectErrorAtTheLine("Sphere 0 0 0 360", {"Sphere"}); }

TEST_F(BadInput, DegeneratePolygon) {
    expectErrorAtTheLine("Polygon \"P\" [0 0 3 1 0 3]", {"Polygon"});
}

// Nothing that could be seen is lost: a warning.
TEST_F(BadInput, PolygonsWithoutArea) {
    const char *table[] = {"Polygon \"P\" [2 2 3 3 3 3 4 4 3]", "Polygon \"P\" [2 2 3 2 2 3 2 2 3]",
                           "PointsPolygons [3 3] [0 1 2 2 1 0] \"P\" [2 2 3 3 3 3 4 4 3]",
                           "PointsPolygons [3 3] [0 1 2 0 1 3] \"P\" [2 2 3 3 3 3 4 4 3 3 4 3]"};
    for (const char *polygons : table) {
        Outcome run = render(sceneWith(polygons));
        EXPECT_EQ(run.status, 0) << polygons << run.text();
        EXPECT_TRUE(run.says("scene.rib:8")) << run.text();
        EXPECT_TRUE(run.says("warning")) << run.text();
        expectDisc();
    }
}

// A lamp so far out that floats leave it no area, and surfaces that scattered rays meet.
TEST_F(BadInput, LampWithoutArea) {
    for (const char *lamp : {"Translate 0 0 4294967296 Rotate 90 1 0 0 Disk 0 .6 360",
                             "Scale 1e-30 1e-30 1e-30 Disk 0 1 360"}) {
        Outcome run = render(sceneWith("Option \"render\" \"string integrator\" [\"path\"]\n"
                                       "AttributeBegin AreaLightSource \"arealight\" 1 " +
                                       std::string(lamp) +
                                       " AttributeEnd Illuminate 1 1\n"
                                       "AttributeBegin Surface \"constant\" Translate 0 3 9\n"
                                       "Sphere 1 -1 1 360 AttributeEnd\n"
                                       "Surface \"matte\" Translate 0 -3 9 Sphere 1 -1 1 360"));
        EXPECT_LE(run.status, 1) << run.text();
    }
}

// Roulette never ends paths that gain at every surface: their splitting must end.
TEST_F(BadInput, SurfacesThatMakeLight) {
    for (const char *integrator : {"path", "classic"}) {
        Outcome run = render(sceneWith(
            "Option \"render\" \"string integrator\" [\"" + std::string(integrator) + "\"]\n" +
            "Surface \"glass\" \"Kr\" [9] \"Kt\" [9]\nSphere 20 -20 20 360\n"
            "Translate 0 0 4 Sphere 1 -1 1 360\nTranslate 2 0 0 Sphere .9 -.9 .9 360"));
        EXPECT_LE(run.status, 1) << run.text();
    }
}

TEST_F(BadInput, VertexThatIsNotANumber) {
    expectErrorAtTheLine("Polygon \"P\" [0 0 3 nan 0 3 1 1 3]", {});
}

// A number too large for a float is infinite.
TEST_F(BadInput, VertexThatIsInfinite) {
    expectErrorAtTheLine("Polygon \"P\" [0 0 3 1e99 0 3 1 1 3]", {"P"});
}

TEST_F(BadInput, SingularTransformationsLeaveOutWhatIsFlat) {
    const std::string transforms[] = {"ConcatTransform [1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 1]",
                                      "Scale 1 0 1", "Scale 0 0 0",
                                      "Transform [1 1 0 0 1 1 0 0 0 0 1 0 0 0 5 1]"};
    for (const std::string &transform : transforms) {
        Outcome run = render(sceneWith("Translate 0 0 4 " + transform +
                                       " Surface \"matte\" "
                                       "LightSource \"pointlight\" 7 Sphere 1 -1 1 360"));
        EXPECT_EQ(run.status, 0) << run.text();
        EXPECT_TRUE(run.says("scene.rib:8")) << run.text();
        EXPECT_TRUE(run.says("Sphere: the transformation is singular")) << run.text();
        expectDisc();
    }
    expectReportedAndRendered("AttributeEnd WorldEnd Scale 1 1 0 WorldBegin WorldEnd Identity "
                              "WorldBegin AttributeBegin",
                              {"singular", "scene.rib:8"});
}

TEST_F(BadInput, TransformationsThatAreNotFinite) {
    for (const char *request : {"Translate 1e99 0 0", "Scale nan 1 1", "Rotate inf 0 0 1",
                                "ConcatTransform [1e99 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]",
                                "Scale 1e30 1 1 Scale 1e30 1 1 Identity"})
        expectErrorAtTheLine(std::string("Translate 9 0 5 ") + request, {});
}

// Each holds the one before twice: more than memory holds, in a few bytes.
TEST_F(BadInput, ObjectsThatMultiply) {
    std::string objects = "ObjectBegin 1 Sphere 1 -1 1 360 ObjectEnd";
    for (int i = 2; i <= 40; ++i) {
        const std::string last = std::to_string(i - 1);
        objects += " ObjectBegin " + std::to_string(i) + " ObjectInstance " + last +
                   " Translate 2 0 0 ObjectInstance " + last + " ObjectEnd";
    }
    expectErrorAtTheLine(objects + " ObjectInstance 40", {"more than 16000000"});
}

TEST_F(BadInput, ObjectsThatDoNotMatch) {
    const std::pair<const char *, const char *> table[] = {
        {"ObjectEnd", "ObjectEnd without ObjectBegin"},
        {"ObjectInstance 3", "no object '3'"},
        {"ObjectBegin 1 ObjectInstance 1 ObjectEnd ObjectInstance 1", "no object '1'"},
        {"ObjectBegin 1 ObjectBegin 2 Sphere 1 -1 1 360 ObjectEnd",
         "ObjectBegin is not legal between ObjectBegin and ObjectEnd"},
        {"ObjectBegin 1 AttributeBegin ObjectEnd", "ObjectEnd: the AttributeBegin at"},
        {"AttributeBegin ObjectBegin 1 AttributeEnd ObjectEnd AttributeEnd",
         "AttributeEnd without AttributeBegin"},
        {"ObjectBegin 1 WorldEnd ObjectEnd WorldBegin AttributeBegin", "is still open"},
    };
    for (auto [requests, said] : table)
        expectErrorAtTheLine(requests, {said});
    expectReportedAndRendered("ObjectInstance 9 ObjectBegin 1 Translate 1e99 0 0 ObjectEnd",
                              {"no object '9'", "Translate"});
}

TEST_F(BadInput, ShaderParameterOfAnotherType) {
    expectErrorAtTheLine("Surface \"matte\" \"string Kd\" [\"much\"] Translate 9 0 5 "
                         "Sphere 1 -1 1 360",
                         {"Kd"});
}

// Every error of the file in one run, each with its line and a caret below the place.
TEST_F(BadInput, ShaderWithErrorsOfSyntaxAndType) {
    folder_.write("broken.sl", "surface broken(float Kd = 1;)\n"
                               "{\n"
                               "    float a = ;\n"
                               "    color c = nosuchfunction(1);\n"
                               "    string m = N . N;\n"
                               "    Ci = undeclared * Cs;\n"
                               "}\n");
    expectReportedAndRendered("Surface \"broken\" Translate 9 0 5 Sphere 1 -1 1 360",
                              {"broken.sl:3:15", "broken.sl:4:15", "nosuchfunction",
                               "broken.sl:5:", "broken.sl:6:10", "undeclared", "    float a = ;\n",
                               "    Ci = undeclared * Cs;\n", "         ^",
                               "scene.rib:" + std::to_string(wrongLine)});
}

TEST_F(BadInput, ShaderThatDividesByZero) {
    folder_.write("nan.sl", "surface nan() { float zero = 0; Ci = color(zero / zero); Oi = 1; }\n");
    Outcome run = render(sceneWith("Surface \"nan\" Translate 0 .75 5 Disk 0 .1 360"));
    EXPECT_EQ(run.signal, 0) << run.text();
    EXPECT_TRUE(run.says("nan")) << run.text();
    expectDisc();
}

// A quad beside the disc with a variable that is not of the size its meaning asks for.
TEST_F(BadInput, VariablesOfAnotherTypeThanTheirMeaning) {
    const std::string quad = "Surface \"usesall\" Translate 0 0 5 Polygon \"P\" [.7 .7 0 .9 .7 0 "
                             ".9 .9 0 .7 .9 0] ";
    folder_.write("usesall.sl", "surface usesall() { Ci = Cs * s + t; Oi = 1; }\n");
    const std::string matrix = " [1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16]";
    const std::string colors = " [1 2 3 4 5 6 7 8 9 10 11 12]";
    for (const std::string &variable :
         {"\"constant matrix Cs\"" + matrix, "\"constant matrix Os\"" + matrix,
          "\"varying color s\"" + colors, "\"varying color t\"" + colors,
          std::string("\"constant float Cs\" [.25]"), std::string("\"constant float st\" [.25]")})
        expectErrorAtTheLine(quad + variable, {"are expected; it is left out"});
}

// Each of them overrides a parameter of its shader.
TEST_F(BadInput, MoreVariablesThanAnyoneExpects) {
    std::string parameters, sum = "0", variables;
    for (int i = 0; i < 60; ++i) {
        const std::string name = "c" + std::to_string(i);
        parameters += "varying color " + name + " = 0; ";
        sum += " + " + name;
        variables += " \"constant color " + name + "\" [.01 .01 .01]";
    }
    folder_.write("many.sl", "surface many(" + parameters + "float a[40] = { 0 };) { Ci = " + sum +
                                 " + a[39]; Oi = 1; }\n");
    variables += " \"constant float[40] a\" [";
    for (int i = 0; i < 40; ++i)
        variables += i == 39 ? "0.4" : "0 ";
    Outcome run =
        render(sceneWith("Surface \"many\" Translate 0 0 4 Disk 0 .5 360" + variables + "]"));
    EXPECT_EQ(run.status, 0) << run.text();
    expectDisc();
}

TEST_F(BadInput, ErrorHandlerAbortStops) {
    Outcome run = render("ErrorHandler \"abort\"\n" + sceneWith("Frobnicate"));
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_FALSE(folder_.has("out.exr"));
}

// The error comes from the shader library and not from the reading of the file.
TEST_F(BadInput, ErrorHandlerAbortHoldsForShaders) {
    Outcome run = render("ErrorHandler \"abort\"\n" + sceneWith("Surface \"nosuchshader\""));
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("stopped at the first error")) << run.text();
    EXPECT_FALSE(folder_.has("out.exr"));
    run = render("ErrorHandler \"ignore\"\n" + sceneWith("Surface \"nosuchshader\""));
    EXPECT_EQ(run.err, "");
    expectDisc();
}

TEST_F(BadInput, MissingShaderNamesEachFolderOnce) {
    RunSettings beside;
    folder_.write("scene.rib", sceneWith("Surface \"nosuchshader\""));
    beside.folder = folder_.path();
    Outcome run = runCandela({"scene.rib", "--shader-path", "."}, beside);
    EXPECT_TRUE(run.says("no \"nosuchshader.sl\" in .")) << run.text();
    EXPECT_FALSE(run.says("., .")) << run.text();
}

TEST_F(BadInput, UnknownPixelFilterHasAPlace) {
    std::string rib = sceneWith("");
    rib.replace(rib.find("\"box\""), 5, "\"lens\"");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("scene.rib:3:1: error: unknown pixel filter \"lens\"")) << run.text();
}

TEST_F(BadInput, UnknownIntegratorHasAPlace) {
    std::string rib = sceneWith("");
    rib.replace(rib.find("\"path\""), 6, "\"magic\"");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(
        run.says("scene.rib:5:1: error: Option: \"render\" \"integrator\" is how light is") &&
        run.says("one of \"path\", \"bidir\", \"vcm\", \"radiosity\", \"classic\", and "
                 "not \"magic\""))
        << run.text();
    expectDisc();
}

TEST_F(BadInput, TextureMemoryThatIsNoAmount) {
    for (const char *value : {"-1", "1e38", "2147483647"}) {
        const std::string option = "Option \"limits\" \"integer texturememory\" ";
        Outcome run = render(option + value + "\n" + sceneWith(""));
        EXPECT_EQ(run.status, 1) << run.text();
        EXPECT_TRUE(run.says("scene.rib:1:")) << run.text();
        EXPECT_TRUE(run.says("texturememory")) << run.text();
        expectDisc();
    }
}

// One of two displays is wrong: the first error is the end, and nothing is rendered.
TEST_F(BadInput, ErrorHandlerAbortHoldsForDisplays) {
    std::string rib = "ErrorHandler \"abort\"\n" + sceneWith("");
    rib.insert(rib.find("Option"), "Display \"+b.exr\" \"openexr\" \"nonsense\"\n");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_FALSE(folder_.has("out.exr"));
}

// Skewed until its coordinates are all but multiples of each other, a sphere is millions of slivers
// in one line, each of which every ray that comes near would try. Flat along an axis it is a disc.
TEST_F(BadInput, SpheresSkewedToALine) {
    const std::string sphere = " 0 1 0 0 0 0 1 0 0 0 5 1] Sphere 1 -1 1 360";
    Outcome run =
        render(sceneWith("Transform [1e18 1e18 1 0" + sphere), {}, {.secondsAllowed = 60});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("Sphere: the transformation is singular")) << run.text();
    run = render(sceneWith("TransformBegin Translate 9 9 5 Scale 1 1 1e-14 Sphere 1 -1 1 360 "
                           "TransformEnd"));
    EXPECT_EQ(run.err, "");
    expectDisc();
}

} // namespace candela::test
