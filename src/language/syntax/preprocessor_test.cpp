// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/include.h"
#include "language/syntax/preprocessor.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gtest/gtest.h>

namespace candela::sl {
namespace {

struct Result {
    DiagnosticList diagnostics;
    SourceSet sources;
    PreprocessedFile file;

    explicit Result(std::string_view text, const PreprocessorOptions &options = {},
                    const std::string &name = "test.sl") {
        sources.push_back(std::make_unique<SourceFile>(name, text));
        Reporter reporter(diagnostics);
        file = preprocess(sources, options, reporter);
    }

    std::string spellings() const {
        std::string result;
        for (size_t i = 0; i + 1 < file.tokens.size(); ++i)
            result += (i ? " " : "") + file.tokens[i].spelling;
        return result;
    }
    std::string firstMessage() const {
        std::string all = diagnostics.text();
        return all.substr(0, all.find('\n'));
    }
};

TEST(Preprocessor, Expands) {
    const std::pair<const char *, const char *> table[] = {
        {"#define A 1\nA B", "1 B"},
        {"#define A B\n#define B A\nA", "A"},
        {"#define F(x, y) x + y\nF(1, 2) F", "1 + 2 F"},
        {"#define F(x) [x]\nF((a, b)) F(F(1))", "[ ( a , b ) ] [ [ 1 ] ]"},
        {"#define F(x) x\nF\n(\n1\n)", "1"},
        {"#define F() 7\nF()", "7"},
        {"#define A(x) x\n#define B A(3)\nB", "3"},
        {"#define F (1)\nF", "( 1 )"},
        {"#define S(x) #x\nS(a + b)", "\"a + b\""},
        {"#define C(a, b) a##b\nC(no, ise)(1)", "noise ( 1 )"},
        {"#define L 1 + \\\n 2\nL", "1 + 2"},
        {"#define A 1\n#undef A\nA", "A"},
        {"#pragma nolint\n#line 7\na", "a"},
        {"#define F(x) x * F(x)\nF(2)", "2 * F ( 2 )"},
        {"#define F(x) x + \\ \n 1\nF(2)", "2 + 1"},
        {"#define A 1 /* one\n or */ + 2\nA", "1 + 2"},
        {"__LINE__\n\n__LINE__ __FILE__", "1 3 \"test.sl\""},
        {"#define HERE(x) __LINE__ x __FILE__\n\nHERE(a)", "3 a \"test.sl\""},
        {"#define S(x) #x\nS(__LINE__)", "\"__LINE__\""},
        {"#define C(a, b) a##b\n#define D(a, b) C(a, b)\nD(x, __LINE__)", "x3"},
        {"\n#if __LINE__ == 2 && defined(__FILE__)\na\n#endif", "a"},
        {"#ifndef __LINE__\na\n#endif\n__LINE__\n__LINE__", "4 5"},
    };
    for (auto [text, expected] : table) {
        Result result(text);
        EXPECT_EQ(result.spellings(), expected) << text;
        EXPECT_EQ(result.firstMessage(), "") << text;
    }
}

TEST(Preprocessor, Conditions) {
    const std::pair<const char *, const char *> table[] = {
        {"#if 1\na\n#else\nb\n#endif\nc", "a c"},
        {"#if 0\na\n#elif 2 > 1\nb\n#elif 1\nd\n#else\nc\n#endif", "b"},
        {"#ifdef X\na\n#else\nb\n#endif", "b"},
        {"#define X\n#ifdef X\na\n#endif\n#ifndef X\nb\n#endif", "a"},
        {"#if defined(X) || !defined Y\na\n#endif", "a"},
        {"#if 0\n#if 1\na\n#else\nb\n#endif\n#error no\n#else\nc\n#endif", "c"},
        {"#if (1 + 2) * 3 == 9 && 7 % 4 == 3\na\n#endif", "a"},
        {"#if UNKNOWN\na\n#else\nb\n#endif", "b"},
        {"#if CANDELA >= 100\na\n#endif", "a"},
        {"#if 1 ? 0 : 1\na\n#else\nb\n#endif", "b"},
    };
    for (auto [text, expected] : table) {
        Result result(text);
        EXPECT_EQ(result.spellings(), expected) << text;
        EXPECT_EQ(result.firstMessage(), "") << text;
    }
}

TEST(Preprocessor, LinesThatDoNotCountMayHoldAnything) {
    const std::pair<const char *, const char *> table[] = {
        {"#if 0\nIt's old code, don't read; 3dfoo @$ \"open\n#endif\na", ""},
        {"#if 1\na\n#elif 3x @\n#else\n@ 3dfoo\n#endif", ""},
        {"#if 0\n#define A @ 3x \"open\n#endif\na", ""},
        {"#pragma foo \"bar\na", ""},
        {"a\n#error don't \"open", "test.sl:2:2: error: #error: don't open"},
        {"a #\n#ident @", ""},
    };
    for (auto [text, expected] : table) {
        Result result(text);
        EXPECT_EQ(result.spellings().substr(0, 1), "a") << text;
        EXPECT_EQ(result.firstMessage(), expected) << text;
    }
}

TEST(Preprocessor, ReportsFlawsWhereTheyCount) {
    const std::pair<const char *, const char *> table[] = {
        {"#define A 3dfoo\n", "test.sl:1:12: error: letters stand directly after the number 3; "
                              "expected an operator between them"},
        {"#define F(x) x\nF(@)",
         "test.sl:2:3: error: stray character '@' outside of a string or comment"},
        {"#if 1 @\n#endif",
         "test.sl:1:7: error: stray character '@' outside of a string or comment"},
        {"#include \"open", "test.sl:1:10: error: string is not closed; expected '\"' before the "
                            "end of the line"},
        {"#define C(a, b) a##b\nC(3, x)",
         "test.sl:2:1: error: '##' makes '3x', which is not one word"},
    };
    for (auto [text, expected] : table)
        EXPECT_EQ(Result(text).firstMessage(), expected) << text;
    EXPECT_EQ(Result("#define F(x) x\nF(@)").spellings(), "");
}

TEST(Preprocessor, DefinesFromOptions) {
    EXPECT_EQ(Result("N M CANDELA_VERSION", {{}, {{"N", "3"}, {"M", ""}}}).spellings().substr(0, 3),
              "3 \"");
}

TEST(Preprocessor, Reports) {
    const std::pair<const char *, const char *> table[] = {
        {"a\n#if 1\nb", "test.sl:2:2: error: conditional is not closed; expected #endif before "
                        "the end of file"},
        {"#endif", "test.sl:1:2: error: #endif without an #if before it"},
        {"#if 1\n#else\n#else\n#endif", "test.sl:3:2: error: #else after #else"},
        {"#if 1 +\n#endif", "test.sl:1:2: error: expected a value in this condition"},
        {"#if 1 / 0\n#endif", "test.sl:1:2: error: division by zero in this condition"},
        {"#frob", "test.sl:1:1: warning: unknown directive #frob is ignored"},
        {"#define 3", "test.sl:1:2: error: expected a name after #define"},
        {"#define F(x) x\nF(1, 2)", "test.sl:2:1: error: macro F takes 1 arguments, but is given "
                                    "2"},
        {"#define F(x) x\n F(1", "test.sl:2:2: error: call of macro F is not closed; expected ')'"},
        {"#define F(x +\n", "test.sl:1:13: error: expected names and ')' in the parameter list of "
                            "macro F"},
        {"#error stop here", "test.sl:1:2: error: #error: stop here"},
        {"#include nothing", "test.sl:1:2: error: expected \"file\" or <file> after #include"},
        {"#include \"none.h\"", "test.sl:1:10: error: cannot read \"none.h\"; searched: ."},
        {"#include \"/proc/self/mem\"",
         "test.sl:1:10: error: cannot read /proc/self/mem: Input/output error"},
        {"#define __LINE__ 3", "test.sl:1:9: error: __LINE__ tells where it stands: it can be "
                               "neither defined nor undefined"},
        {"#undef __FILE__", "test.sl:1:8: error: __FILE__ tells where it stands: it can be "
                            "neither defined nor undefined"},
        {"#if 1 2\n#endif", "test.sl:1:7: error: unexpected '2' in this condition"},
        {"#if 1 ? 2\n#endif", "test.sl:1:2: error: expected ':' in this condition"},
        {"#if (1\n#endif", "test.sl:1:2: error: expected ')' in this condition"},
        {"#if *\n#endif", "test.sl:1:5: error: expected a value in this condition, not '*'"},
        {"#ifdef 3\n#endif", "test.sl:1:2: error: expected a macro's name after #ifdef"},
        {"#ifndef\n#endif", "test.sl:1:2: error: expected a macro's name after #ifndef"},
        {"#if defined +\n#endif", "test.sl:1:5: error: expected a macro's name after 'defined'"},
        {"#if defined(\n#endif", "test.sl:1:5: error: expected a macro's name after 'defined'"},
        {"#undef", "test.sl:1:2: error: expected a macro's name after #undef"},
        {"#undef 3", "test.sl:1:2: error: expected a macro's name after #undef"},
        {"#warning look here", "test.sl:1:2: warning: #warning: look here"},
        {"#elif 1", "test.sl:1:2: error: #elif without an #if before it"},
    };
    for (auto [text, expected] : table)
        EXPECT_EQ(Result(text).firstMessage(), expected) << text;
}

TEST(Preprocessor, PlacesOfMacrosAreThoseOfTheirUse) {
    Result result("#define A x y\n\n  A z");
    ASSERT_EQ(result.file.tokens.size(), 4u);
    EXPECT_EQ(result.file.tokens[1].where.line, 3);
    EXPECT_EQ(result.file.tokens[1].where.column, 3);
    EXPECT_EQ(result.file.tokens[2].where.column, 5);
}

TEST(Preprocessor, GrowthAndNestingHaveLimits) {
    std::string text = "#define A0 x x\n";
    for (int i = 1; i < 60; ++i) {
        std::string inner = "A" + std::to_string(i - 1);
        text += "#define A" + std::to_string(i) + " " + inner + " " + inner + "\n";
    }
    EXPECT_EQ(Result(text + "A59").diagnostics.count(Severity::Error), 1);

    std::string chain;
    for (int i = 0; i < 20000; ++i)
        chain += "#define A" + std::to_string(i) + " A" + std::to_string(i + 1) + "\n";
    EXPECT_EQ(Result(chain + "A0").diagnostics.count(Severity::Error), 1);
    EXPECT_EQ(Result(chain + "A19500").diagnostics.count(Severity::Error), 0);

    std::string nested = "#define F(x) x\n";
    for (int i = 0; i < 5000; ++i)
        nested += "F(";
    EXPECT_GE(Result(nested + "1" + std::string(5000, ')')).diagnostics.count(Severity::Error), 1);

    EXPECT_GE(
        Result("#if " + std::string(5000, '(') + "\n#endif").diagnostics.count(Severity::Error), 1);
}

class PreprocessorFiles : public testing::Test {
protected:
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("candela_pp_" + std::to_string(getpid()));

    void SetUp() override { std::filesystem::create_directories(folder / "inc"); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    void write(const std::string &name, const std::string &text) {
        std::ofstream(folder / name) << text;
    }
    Result run(const std::string &text) {
        return Result(text, {{(folder / "inc").string()}, {}}, (folder / "main.sl").string());
    }
};

TEST_F(PreprocessorFiles, Includes) {
    write("near.h", "near #include \"far.h\"\n#include \"far.h\"\n");
    write("inc/far.h", "far");
    Result result = run("#include \"near.h\"\n#include <far.h>\nmain");
    EXPECT_EQ(result.spellings(), "near # include \"far.h\" far far main");
    ASSERT_EQ(result.file.includedFiles.size(), 2u);
    EXPECT_EQ(result.file.includedFiles[1], (folder / "inc" / "far.h").string());
    EXPECT_EQ(result.file.tokens[4].where.file->name(), result.file.includedFiles[1]);
}

TEST_F(PreprocessorFiles, IncludeGuardsAndSelfInclusion) {
    write("guard.h", "#ifndef G\n#define G\nonce\n#endif");
    EXPECT_EQ(run("#include \"guard.h\"\n#include \"guard.h\"").spellings(), "once");
    write("self.h", "#include \"self.h\"\n#include \"self.h\"\n");
    EXPECT_GE(run("#include \"self.h\"").diagnostics.count(Severity::Error), 1);
}

TEST_F(PreprocessorFiles, TheirLinesAndNames) {
    write("where.h", "\n__LINE__ __FILE__ HERE");
    EXPECT_EQ(run("#define HERE __LINE__\n\n#include \"where.h\"\nHERE").spellings(),
              "2 \"" + (folder / "where.h").string() + "\" 2 4");
}

TEST_F(PreprocessorFiles, OfNoMoreBytesThanAShaderMayHave) {
    write("large.h", "");
    std::filesystem::resize_file(folder / "large.h", sourceSizeLimit + 1);
    EXPECT_EQ(run("#include \"large.h\"").firstMessage(),
              (folder / "main.sl").string() + ":1:10: error: cannot read " +
                  (folder / "large.h").string() + ": it has more than 16777216 bytes");
}

TEST_F(PreprocessorFiles, AConditionalEndsInItsFile) {
    write("open.h", "#if 1\n");
    Result result = run("#include \"open.h\"\na");
    EXPECT_EQ(result.spellings(), "a");
    EXPECT_EQ(result.diagnostics.count(Severity::Error), 1);
}

} // namespace
} // namespace candela::sl
