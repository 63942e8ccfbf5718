// SPDX-License-Identifier: Apache-2.0
// Each row of *.rows by the interpreter, by code for 16 lanes and by code for one.
#include "sl/rows.h"

#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/lower/lower.h"
#include "language/jit/jit.h"
#include "language/semantics/front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

namespace candela::sl::test {
namespace {

constexpr int points = 19; // A block and a part of one.

/// What the rows are told of their point; all points are the same.
void setInputs(ir::TestBatch &batch) {
    struct Given {
        ShaderInput input;
        std::vector<float> value;
    };
    const Given given[] = {{ShaderInput::P, {1, 2, 3}},
                           {ShaderInput::N, {0, 0, -2}},
                           {ShaderInput::Ng, {0, 0, -1}},
                           {ShaderInput::I, {0, 0, 4}},
                           {ShaderInput::E, {0, 0, 0}},
                           {ShaderInput::dPdu, {2, 0, 0}},
                           {ShaderInput::dPdv, {0, 3, 0}},
                           {ShaderInput::u, {0.25f}},
                           {ShaderInput::v, {0.75f}},
                           {ShaderInput::du, {0.125f}},
                           {ShaderInput::dv, {0.25f}},
                           {ShaderInput::s, {0.5f}},
                           {ShaderInput::t, {0.375f}},
                           {ShaderInput::Cs, {0.25f, 0.5f, 0.75f}},
                           {ShaderInput::Os, {1, 0.5f, 0}},
                           {ShaderInput::time, {0.5f}},
                           {ShaderInput::dsdu, {1}},
                           {ShaderInput::dsdv, {0}},
                           {ShaderInput::dtdu, {0}},
                           {ShaderInput::dtdv, {1}},
                           {ShaderInput::orientation, {1}},
                           {ShaderInput::rayDepth, {2}},
                           {ShaderInput::seed, {std::bit_cast<float>(0x1234567u)}}};
    for (const Given &one : given)
        for (size_t c = 0; c < one.value.size(); ++c)
            batch.inputs[size_t(one.input) + c].assign(size_t(batch.padded()), one.value[c]);
    std::ranges::fill(batch.parameters, 0.0f); // Hidden ones: nothing is given.
    batch.setSamples(1, 1);                    // One light: from the viewer, white.
    const float L[3] = {0, 0, -1};
    for (int c = 0; c < 3; ++c) {
        std::ranges::fill(batch.samples.L[size_t(c)], L[c]);
        std::ranges::fill(batch.samples.Cl[size_t(c)], 1.0f);
    }
    batch.answers.givesTraced = batch.answers.givesAmbient = false;
}

/// Rows that share a shader, as compiling takes longer than running.
class Group {
public:
    void add(const Row &row) { rows_.push_back(row); }
    bool takes(const Row &row) const {
        return rows_.empty() ||
               (rows_.size() < 24 && row.before.empty() && rows_[0].before.empty());
    }

    void check() {
        if (rows_.empty())
            return;
        DiagnosticList diagnostics;
        const auto front = analyzeSource({"rows.sl", source()}, {}, diagnostics);
        const auto lowered =
            front ? ir::lower(*front->shaders[0], {}, {}, diagnostics) : std::nullopt;
        if (!lowered)
            return alone(diagnostics);
        const ir::Function &whole = lowered->whole;
        ir::TestBatch batch(whole, points, 7);
        setInputs(batch);
        compare(whole,
                batch.run(whole, [](const ir::Function &f,
                                    const ShaderArgs &args) { ir::interpret(f, args); }),
                "interpreter");
        for (int width : {laneBlock, 1}) {
            JitOptions options;
            options.width = width;
            Jit jit(options, diagnostics);
            const ShaderFunction code = jit.compile(whole);
            ASSERT_TRUE(code) << diagnostics.text();
            compare(whole,
                    batch.run(whole,
                              [&](const ir::Function &, const ShaderArgs &args) { code(&args); }),
                    width == 1 ? "1 lane" : "16 lanes");
        }
    }

private:
    std::string source() const {
        std::string text = rows_[0].before + "surface rows(";
        for (size_t i = 0; i < rows_.size(); ++i)
            text += "output varying " + rows_[i].type + " r" + std::to_string(i) + " = 0;\n";
        text += ") {\n";
        for (size_t i = 0; i < rows_.size(); ++i) {
            const std::string of = std::to_string(i);
            text += "{ " + rows_[i].type + " result = 0; " + rows_[i].statements() + " r" + of +
                    " = result; }\n";
        }
        return text + "}\n";
    }

    /// One of the rows does not compile: which?
    void alone(const DiagnosticList &diagnostics) {
        if (rows_.size() == 1) {
            ADD_FAILURE() << rows_[0].where << ": " << rows_[0].code << "\n" << diagnostics.text();
            return;
        }
        for (const Row &row : rows_) {
            Group one;
            one.add(row);
            one.check();
        }
    }

    static bool allNear(const ir::TestPlane &found, float expected, float tolerance) {
        const float allowed = tolerance * std::max(1.0f, std::abs(expected));
        return std::all_of(found.begin(), found.begin() + points,
                           [&](float x) { return std::abs(x - expected) <= allowed; });
    }

    void compare(const ir::Function &whole, const std::vector<ir::TestPlane> &planes,
                 const char *by) const {
        for (size_t i = 0; i < rows_.size(); ++i) {
            const Row &row = rows_[i];
            std::vector<const ir::TestPlane *> own;
            for (size_t k = 0; k < planes.size(); ++k)
                if (whole.outputs[k].name.text() == "r" + std::to_string(i))
                    own.push_back(&planes[k]);
            ASSERT_EQ(own.size(), row.expected.size()) << row.where << ": " << row.code;
            for (size_t c = 0; c < own.size(); ++c)
                EXPECT_TRUE(allNear(*own[c], row.expected[c], row.tolerance))
                    << row.where << " by " << by << ", component " << c << ": " << row.code
                    << " is " << (*own[c])[0] << " at the first point, expected "
                    << row.expected[c];
        }
    }

    std::vector<Row> rows_;
};

class Rows : public testing::TestWithParam<std::string> {};

TEST_P(Rows, GiveKnownValues) {
    Group group;
    for (const Row &row : readRows(GetParam())) {
        if (!group.takes(row)) {
            group.check();
            group = Group();
        }
        group.add(row);
    }
    group.check();
}

INSTANTIATE_TEST_SUITE_P(All, Rows, testing::ValuesIn(rowFiles()), [](const auto &info) {
    return std::filesystem::path(info.param).stem().string();
});

} // namespace
} // namespace candela::sl::test
