// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/declarations.h"

#include <gtest/gtest.h>

namespace candela {

TEST(Declarations, allFormsAreRead) {
    struct {
        const char *text;
        Declaration expected;
    } cases[] = {
        {"float", {StorageClass::Uniform, ValueType::Float, 1}},
        {"varying color", {StorageClass::Varying, ValueType::Color, 1}},
        {"uniform float[2]", {StorageClass::Uniform, ValueType::Float, 2}},
        {"  vertex\thpoint ", {StorageClass::Vertex, ValueType::HPoint, 1}},
        {"facevarying float [ 2 ]", {StorageClass::FaceVarying, ValueType::Float, 2}},
        {"facevertex normal", {StorageClass::FaceVertex, ValueType::Normal, 1}},
        {"constant int[3]", {StorageClass::Constant, ValueType::Integer, 3}},
        {"matrix", {StorageClass::Uniform, ValueType::Matrix, 1}},
    };
    for (const auto &each : cases)
        EXPECT_EQ(parseDeclaration(each.text), each.expected) << each.text;
}

TEST(Declarations, malformedOnesAreNone) {
    for (const char *text : {"", "uniform", "floats", "float[0]", "float[-1]", "float[2", "float[]",
                             "float x", "color uniform", "float[99999999999]"})
        EXPECT_EQ(parseDeclaration(text), std::nullopt) << text;
}

TEST(Declarations, tokensMayCarryTheirDeclaration) {
    auto token = parseToken("uniform float[2] dims");
    ASSERT_TRUE(token);
    EXPECT_EQ(token->name, "dims");
    EXPECT_EQ(token->declaration, (Declaration{StorageClass::Uniform, ValueType::Float, 2}));
    token = parseToken("Kd");
    ASSERT_TRUE(token);
    EXPECT_EQ(token->name, "Kd");
    EXPECT_FALSE(token->declaration);
    EXPECT_EQ(parseToken("color")->name, "color"); // A type's name alone is a parameter's.
    for (const char *text : {"", "  ", "uniform flat x", "float a b", "varying x"})
        EXPECT_FALSE(parseToken(text)) << text;
}

TEST(Declarations, textsAreReadBackTheSame) {
    for (const char *text : {"uniform float", "varying color[7]", "facevertex string"})
        EXPECT_EQ(textOf(*parseDeclaration(text)), text);
}

TEST(Declarations, componentsAreCounted) {
    EXPECT_EQ(parseDeclaration("point[4]")->components(), 12);
    EXPECT_EQ(parseDeclaration("matrix")->components(), 16);
    EXPECT_EQ(parseDeclaration("color")->components(), colorSamples);
}

TEST(Declarations, theUserComesBeforeTheStandard) {
    Dictionary dictionary;
    EXPECT_EQ(Dictionary::standard("P")->storage, StorageClass::Vertex);
    EXPECT_FALSE(dictionary.declaredByUser("P"));
    dictionary.declare("P", *parseDeclaration("varying point"));
    EXPECT_EQ(dictionary.declaredByUser("P")->storage, StorageClass::Varying);
}

TEST(Declarations, valuesAreHeldAgainstTheirType) {
    DiagnosticList found;
    TokenValue numbers{"x", {}, {1, 2}, {}}, words{"x", {}, {}, {"a"}};
    ParsedToken token{"x", std::nullopt};
    auto floats2 = *parseDeclaration("float[2]"), text = *parseDeclaration("string");
    EXPECT_TRUE(singleValue(numbers, token, floats2, "Surface", found));
    EXPECT_TRUE(singleValue(words, token, text, "Surface", found));
    EXPECT_EQ(found.count(Severity::Error), 0);
    EXPECT_FALSE(singleValue(words, token, floats2, "Surface", found));
    EXPECT_FALSE(singleValue(numbers, token, text, "Surface", found));
    EXPECT_FALSE(singleValue(numbers, token, *parseDeclaration("color"), "Surface", found));
    EXPECT_EQ(found.count(Severity::Error), 3);
    EXPECT_NE(found.text().find("expected 3 values, found 2"), std::string::npos);
}

TEST(Declarations, arraysHaveALimit) {
    EXPECT_TRUE(parseDeclaration("constant color[1048576]"));
    EXPECT_FALSE(parseDeclaration("constant color[1048577]"));
    EXPECT_FALSE(parseDeclaration("constant color[1431655766]"));
    EXPECT_FALSE(parseToken("constant color[1431655766] Cs"));
}

} // namespace candela
