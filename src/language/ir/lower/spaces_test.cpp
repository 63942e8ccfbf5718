// SPDX-License-Identifier: Apache-2.0
// Named spaces against the transformations of foundation/base.
#include "foundation/base/matrix4.h"
#include "language/ir/lower/test_support.h"

namespace candela::ir {
namespace {

const Matrix4 worldMatrix = rotation(40, {1, 2, 3}) * scaling(2, 1, 0.5f) * translation(1, 2, 3);
const Matrix4 shaderMatrix = scaling(1, 3, 1) * rotation(-70, {0, 1, 1}) * translation(-1, 0, 4);
const Matrix4 objectMatrix = skew(30, {0, 1, 0}, {1, 0, 0}) * translation(5, 5, 5);

std::vector<float> pairOf(const Matrix4 &currentFromSpace) {
    std::vector<float> result(currentFromSpace.m.begin(), currentFromSpace.m.end());
    const Matrix4 back = *inverse(currentFromSpace);
    result.insert(result.end(), back.m.begin(), back.m.end());
    return result;
}

/// Runs a body with "world", "shader" and "object" as above.
std::vector<ShaderRun::Plane> inSpaces(const std::string &type, const std::string &body) {
    ShaderRun run(surfaceWith(type, body));
    EXPECT_TRUE(run.lowered) << run.diagnostics.text();
    if (!run.lowered)
        return std::vector<ShaderRun::Plane>(16, ShaderRun::Plane(32));
    for (size_t i = 0; i < run.lowered->whole.spaces.size(); ++i) {
        EXPECT_EQ(run.lowered->whole.spaces[i], "world");
        run.batch->spaces[i] = pairOf(worldMatrix);
    }
    run.setParameter("shader", pairOf(shaderMatrix));
    run.batch->objects = pairOf(objectMatrix);
    return run.run().at("result");
}

void expectNear(const std::vector<ShaderRun::Plane> &planes, Vec3 expected) {
    EXPECT_NEAR(planes[0][0], expected.x, 1e-4);
    EXPECT_NEAR(planes[1][0], expected.y, 1e-4);
    EXPECT_NEAR(planes[2][0], expected.z, 1e-4);
}

const Vec3 p{0.5f, -2, 3};

TEST(LowerSpaces, ConstructorsWithASpace) {
    expectNear(inSpaces("point", "result = point \"world\" (0.5, -2, 3);"),
               transformPoint(worldMatrix, p));
    expectNear(inSpaces("vector", "result = vector \"shader\" (0.5, -2, 3);"),
               transformVector(shaderMatrix, p));
    expectNear(inSpaces("normal", "result = normal \"object\" (0.5, -2, 3);"),
               transformNormal(*inverse(objectMatrix), p));
    expectNear(inSpaces("point", "result = point \"current\" (0.5, -2, 3);"), p);
}

TEST(LowerSpaces, TransformFunctions) {
    expectNear(inSpaces("point", "result = transform(\"world\", point(0.5, -2, 3));"),
               transformPoint(*inverse(worldMatrix), p));
    expectNear(inSpaces("point", "result = transform(\"world\", \"object\", point(0.5, -2, 3));"),
               transformPoint(worldMatrix * *inverse(objectMatrix), p));
    expectNear(
        inSpaces("vector", "result = vtransform(\"shader\", \"current\", vector(0.5, -2, 3));"),
        transformVector(shaderMatrix, p));
    expectNear(inSpaces("normal", "result = ntransform(\"world\", normal(0.5, -2, 3));"),
               transformNormal(worldMatrix, p));
    expectNear(inSpaces("point", "result = transform(\"world\", \"world\", point(0.5, -2, 3));"),
               p);
}

TEST(LowerSpaces, TransformByMatrices) {
    const char *m = "matrix m = matrix(1,0,0,0, 0,2,0,0, 1,0,3,0, 1,2,3,1); ";
    const Matrix4 matrix{{1, 0, 0, 0, 0, 2, 0, 0, 1, 0, 3, 0, 1, 2, 3, 1}};
    expectNear(inSpaces("point", std::string(m) + "result = transform(m, point(0.5, -2, 3));"),
               transformPoint(matrix, p));
    expectNear(inSpaces("normal", std::string(m) + "result = ntransform(m, normal(0.5, -2, 3));"),
               transformNormal(*inverse(matrix), p));
    expectNear(
        inSpaces("point", std::string(m) + "result = transform(\"world\", m, point(0.5, -2, 3));"),
        transformPoint(worldMatrix * matrix, p));
}

/// A projection divides by w.
TEST(LowerSpaces, HomogeneousDivide) {
    expectNear(inSpaces("point", "result = transform(matrix(1,0,0,0, 0,1,0,0, 0,0,1,1, 0,0,-1,0), "
                                 "point(2, 4, 2));"),
               {1, 2, 0.5f});
}

TEST(LowerSpaces, MatricesStartAtCurrentSpace) {
    // matrix "world" M takes points to world space and does M there.
    expectNear(inSpaces("point",
                        "matrix m = matrix \"world\" (2,0,0,0, 0,1,0,0, 0,0,1,0, 0,1,0,1); "
                        "result = transform(m, point \"world\" (1, 1, 1));"),
               {2, 2, 1});
    expectNear(inSpaces("point", "matrix m = matrix \"shader\" 1; "
                                 "result = transform(m, P) - transform(\"shader\", P);"),
               {0, 0, 0});
}

TEST(LowerSpaces, MtransformActsTheSameElsewhere) {
    const auto back = inSpaces("matrix", "matrix m = matrix(2,0,0,0, 0,1,0,0, 0,0,1,0, 0,1,0,1); "
                                         "result = mtransform(\"object\", \"current\", "
                                         "mtransform(\"object\", m));");
    const float expected[16] = {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 1};
    for (int k = 0; k < 16; ++k)
        EXPECT_NEAR(back[k][0], expected[k], 1e-4);
}

TEST(LowerSpaces, DepthReadsItsSpace) {
    ShaderRun run(surfaceWith("float", "result = depth(P);"));
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    ASSERT_EQ(run.lowered->whole.spaces, std::vector<std::string>{"depth"});
    // Camera = current; near 1, far 5.
    run.batch->spaces[0] = pairOf(scaling(1, 1, 4) * translation(0, 0, 1));
    run.setInput(ShaderInput::P, {7, 8, 2});
    EXPECT_FLOAT_EQ(run.run().at("result")[0][0], 0.25f);
}

TEST(LowerSpaces, PicturesHaveNone) {
    for (const char *shader :
         {"filter f() { setimage(\"Ci\", 0, 0, depth(transform(\"world\", point \"object\" 1))); }",
          "imager f() { Ci = depth(transform(\"world\", point \"object\" 1)) "
          "+ comp(mtransform(\"shader\", matrix \"camera\" 1), 0, 0); }"}) {
        const ShaderRun run(shader);
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        EXPECT_TRUE(run.lowered->whole.spaces.empty());
        EXPECT_TRUE(run.lowered->whole.parameters.empty());
        for (const char *space : {"\"depth\"", "\"world\"", "\"object\""})
            EXPECT_NE(run.diagnostics.text().find(std::string("the space ") + space),
                      std::string::npos)
                << run.diagnostics.text();
    }
}

} // namespace
} // namespace candela::ir
