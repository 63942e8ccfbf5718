// SPDX-License-Identifier: Apache-2.0
// A mistake made very often: a few of its messages and how many more there were.
#include "tests/bad_input/bad_input.h"

#include <algorithm>

namespace candela::test {

namespace {

long lines(const std::string &text) { return std::count(text.begin(), text.end(), '\n'); }

std::string repeated(const std::string &request, int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
        text += request + "\n";
    return text;
}

} // namespace

TEST_F(BadInput, TenThousandBadPrimitivesAreTwentyOneLines) {
    Outcome run = render(sceneWith(repeated("Sphere 0 0 0 360", 10000)));
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(lines(run.err), 21) << run.err.substr(0, 4000);
    EXPECT_TRUE(run.says("9980 more like this: Sphere: it is degenerate")) << run.text();
    expectDisc();
}

TEST_F(BadInput, NumbersAndNamesMakeNoNewKind) {
    std::string wrong;
    for (int i = 0; i < 500; ++i) {
        const std::string number = std::to_string(i);
        wrong += "ObjectInstance " + number +
                 "\nPolygon \"P\" [0 0 3 1 0 3 1 1 3] \"varying float s" + "\" [" +
                 repeated(number, 4 + i) + "]\n";
    }
    Outcome run = render(sceneWith(wrong));
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(lines(run.err), 2 * 21) << run.err.substr(0, 8000);
    EXPECT_TRUE(run.says("480 more like this: ObjectInstance: no object '20'")) << run.text();
    expectDisc();
}

// A shader that a program wrote may be one line: each error quotes the part that it is about.
TEST_F(BadInput, ManyErrorsOnOneLongLine) {
    std::string shader = "surface broken() { ";
    for (int i = 10; i < 60; ++i)
        shader += "Ci = Cs * undeclared" + std::to_string(i) + " + color(0.25, 0.50, 1.00);  ";
    folder_.write("broken.sl", shader + "}\n");
    Outcome run = render(sceneWith("Surface \"broken\" Translate 9 0 5 Sphere 1 -1 1 360"));
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_GE(shader.size(), 2500u);
    EXPECT_LE(run.err.size(), 25u * 500u) << run.text();
    EXPECT_TRUE(run.says("Ci = Cs * undeclared10 + ")) << run.text();
    EXPECT_TRUE(run.says("Ci = Cs * undeclared29 + ")) << run.text();
    expectDisc();
}

// A shader is compiled once for each of its strings, and its text is as wrong each time.
TEST_F(BadInput, ShadersWithManyStringsSpeakOnce) {
    folder_.write("held.sl", "surface held(string map = \"\";)\n"
                             "{ Oi = 1; Ci = map == \"a\" ? 1 : Du(length(dPdu)); }\n");
    std::string surfaces;
    for (int i = 0; i < 30; ++i)
        surfaces += "Surface \"held\" \"string map\" [\"" + std::to_string(i) +
                    "\"] Translate 9 0 5 Sphere 1 -1 1 360\n";
    Outcome run = render(sceneWith("AttributeBegin\n" + surfaces + "AttributeEnd"));
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("held.sl:1:")) << run.text();
    EXPECT_EQ(lines(run.err), 3) << run.text(); // With the line of the text, and its caret.
    expectDisc();
}

// What is not printed counts all the same, and warnings stay warnings.
TEST_F(BadInput, SuppressionLeavesTheExitStatus) {
    Outcome run = render(sceneWith("Scale 1 0 1\n" + repeated("Sphere 1 -1 1 360", 100)));
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(lines(run.err), 21) << run.text();
    run =
        render(sceneWith("Scale 1 0 1\n" + repeated("Sphere 1 -1 1 360", 100) + "Sphere 0 0 0 1"));
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_EQ(lines(run.err), 22) << run.text();
    run = render("ErrorHandler \"ignore\"\n" + sceneWith(repeated("Sphere 0 0 0 360", 100)));
    EXPECT_EQ(run.err, "");
}

} // namespace candela::test
