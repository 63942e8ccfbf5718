// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/builtins.h"

#include <set>

#include <gtest/gtest.h>

#include "language/semantics/predefined.h"

namespace candela::sl {
namespace {

TEST(Builtins, TableIsSound) {
    std::set<std::string> names;
    for (const Builtin &function : builtins()) {
        EXPECT_TRUE(names.insert(function.name).second) << function.name << " stands twice";
        EXPECT_EQ(findBuiltin(function.name), &function);
        EXPECT_EQ(&builtin(function.id), &function);
        EXPECT_FALSE(function.overloads.empty()) << function.name;
        EXPECT_FALSE(std::string(function.doc).empty()) << function.name;
        std::set<std::string> signatures;
        for (const BuiltinOverload &overload : function.overloads) {
            EXPECT_EQ(overload.function, &function);
            EXPECT_TRUE(signatures.insert(overload.signature()).second) << overload.signature();
            for (const BuiltinParameter &parameter : overload.parameters) {
                EXPECT_FALSE(parameter.name.empty()) << overload.signature();
                EXPECT_NE(parameter.type, BaseType::Void) << overload.signature();
            }
        }
    }
    EXPECT_EQ(findBuiltin("nonsense"), nullptr);
}

TEST(Builtins, SignaturesAreReadInFull) {
    const std::pair<const char *, const char *> table[] = {
        {"sin", "float sin(float angle)"},
        {"max", "float max(float a, float b...)"},
        {"arraylength", "float arraylength(any a[])"},
        {"printf", "void printf(uniform string pattern, ...)"},
        {"setxcomp", "void setxcomp(output vector v, float x)"},
        {"random", "float random()"},
        {"shadername", "string shadername()"},
    };
    for (auto [name, signature] : table)
        EXPECT_EQ(findBuiltin(name)->overloads[0].signature(), signature);
    EXPECT_EQ(findBuiltin("noise")->overloads.size(), 20u);
    EXPECT_EQ(findBuiltin("fresnel")->overloads[1].parameters.size(), 7u);
    EXPECT_TRUE(findBuiltin("fresnel")->overloads[1].parameters[6].output);
    EXPECT_TRUE(findBuiltin("spline")->overloads.back().parameters.back().array);
}

TEST(Builtins, WhatMustBeAvailableIs) {
    for (const char *name : {"noise",
                             "pnoise",
                             "cellnoise",
                             "spline",
                             "smoothstep",
                             "mix",
                             "ctransform",
                             "transform",
                             "vtransform",
                             "ntransform",
                             "mtransform",
                             "rotate",
                             "refract",
                             "fresnel",
                             "faceforward",
                             "reflect",
                             "random",
                             "printf",
                             "format",
                             "concat",
                             "arraylength",
                             "ambient",
                             "diffuse",
                             "specular",
                             "specularbrdf",
                             "phong",
                             "trace",
                             "irradiance",
                             "photometric",
                             "radiometric",
                             "totalluminance",
                             "totalradiance",
                             "depth",
                             "area",
                             "calculatenormal",
                             "Du",
                             "Dv",
                             "Deriv",
                             "option",
                             "rendererinfo",
                             "image",
                             "setimage",
                             "setsize",
                             "texture",
                             "environment",
                             "shadow",
                             "bump",
                             "textureinfo",
                             "surface",
                             "lightsource"}) {
        ASSERT_NE(findBuiltin(name), nullptr) << name;
        EXPECT_EQ(findBuiltin(name)->available, Available::Now) << name;
    }
    for (const char *name : {"occlusion", "bake"}) {
        ASSERT_NE(findBuiltin(name), nullptr) << name;
        EXPECT_EQ(findBuiltin(name)->available, Available::Later) << name;
    }
}

TEST(Predefined, KindsKnowTheirVariables) {
    using enum ShaderKind;
    EXPECT_TRUE(findPredefined("Ps", Light));
    EXPECT_FALSE(findPredefined("Ps", Surface));
    EXPECT_TRUE(findPredefined("xsize", Filter));
    EXPECT_FALSE(findPredefined("P", Filter));
    EXPECT_TRUE(predefinedVariable(PredefinedId::Cl).writableIn(Light));
    EXPECT_FALSE(predefinedVariable(PredefinedId::Cl).writableIn(Surface));
    EXPECT_TRUE(predefinedVariable(PredefinedId::P).writableIn(Displacement));
    EXPECT_TRUE(predefinedVariable(PredefinedId::DCiDu).writableIn(Surface));
    for (const PredefinedVariable &variable : predefinedVariables()) {
        EXPECT_EQ(variable.writable & ~variable.readable, 0u) << variable.name;
        EXPECT_EQ(&predefinedVariable(variable.id), &variable);
    }
}

} // namespace
} // namespace candela::sl
