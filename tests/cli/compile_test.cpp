// SPDX-License-Identifier: Apache-2.0
// `candela compile`: shaders checked, put into the cache, and printed.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/stat.h>

namespace candela::test {

namespace {

const std::string tinted = "surface tinted(float Kd = .5)\n"
                           "{\n"
                           "    Ci = Kd * diffuse(normalize(N)) + Cs * smoothstep(0, 1, Du(s));\n"
                           "    Oi = Os;\n"
                           "}\n";
const std::string lamp = "light lamp(float intensity = TIMES) {\n"
                         "#include \"body.h\"\n"
                         "}\n";

class CompileVerb : public testing::Test {
protected:
    ScratchFolder folder_;

    Outcome compile(std::vector<std::string> arguments, const std::string &input = "") {
        arguments.insert(arguments.begin(), "compile");
        return runCandela(arguments, {.input = input});
    }
    static bool has(const std::string &text, const std::string &part) {
        return text.find(part) != std::string::npos;
    }
};

} // namespace

TEST_F(CompileVerb, SaysWhatWasFoundOfEveryShader) {
    const Outcome run = compile({folder_.write("tinted.sl", tinted), "-DTIMES=3",
                                 folder_.write("constant.sl", "surface c() { Ci = Cs; }")});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(has(run.out, "surface tinted: 1 cone, affine in the light, ")) << run.out;
    EXPECT_TRUE(has(run.out, "surface c: 0 cones, affine in the light, may emit, ")) << run.out;
    EXPECT_EQ(compile({"--quiet", folder_.path("tinted.sl")}).out, "");
}

TEST_F(CompileVerb, IncludesAndDefines) {
    folder_.write("inc/body.h", "solar() Cl = intensity;\n");
    const std::string file = folder_.write("lamp.sl", lamp);
    const Outcome run =
        compile({"-I", folder_.path("inc"), "-D", "TIMES=2.5", file, "--emit", "passes"});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(has(run.out, "parameter uniform float intensity = 2.5")) << run.out;
    EXPECT_TRUE(has(run.out, "; lamp: light\n")) << run.out;
    const Outcome missing = compile({"-DTIMES", file});
    EXPECT_EQ(missing.status, 1);
    EXPECT_TRUE(missing.says("lamp.sl:2:")) << missing.err;
}

TEST_F(CompileVerb, ErrorsOfAllFilesAndAStatus) {
    const Outcome run = compile({folder_.write("bad.sl", "surface b() { Ci = frob(1); }"),
                                 folder_.path("missing.sl"), folder_.write("good.sl", tinted)});
    EXPECT_EQ(run.status, 1);
    EXPECT_TRUE(run.says("bad.sl:1:20: ")) << run.err;
    EXPECT_TRUE(run.says("missing.sl")) << run.err;
    EXPECT_TRUE(has(run.out, "surface tinted")) << run.out;
    EXPECT_EQ(compile({}).status, 2);
    EXPECT_EQ(compile({folder_.path("good.sl"), "--emit", "tree"}).status, 2);
    const Outcome kind = compile({folder_.path("good.sl"), "--question", "light"});
    EXPECT_EQ(kind.status, 1);
    EXPECT_TRUE(kind.says("no entry point \"light\"")) << kind.err;
}

TEST_F(CompileVerb, PrintsAllPassesInOrder) {
    const Outcome run = compile({folder_.write("tinted.sl", tinted), "--emit", "passes"});
    EXPECT_EQ(run.status, 0) << run.text();
    size_t at = 0;
    for (const char *pass :
         {"check", "lower", "derivatives", "clean up", "fold", "light rule", "plan", "shade",
          "surface", "view", "prepare", "scatter", "emit", "opacity"}) {
        const size_t found = run.out.find("; tinted: " + std::string(pass) + "\n");
        ASSERT_NE(found, std::string::npos) << pass;
        EXPECT_GE(found, at) << pass;
        at = found;
    }
}

TEST_F(CompileVerb, PrintsOneEntryPointInAllForms) {
    const std::string file = folder_.write("tinted.sl", tinted);
    const auto emit = [&](const char *form) {
        const Outcome run = compile({file, "--emit", form, "--question", "opacity"});
        EXPECT_EQ(run.status, 0) << run.text();
        return run.out;
    };
    EXPECT_TRUE(has(emit("ir"), "; tinted.opacity\nfunction tinted.opacity "));
    EXPECT_FALSE(has(emit("ir"), "tinted.shade"));
    EXPECT_TRUE(has(emit("llvm"), "define "));
    EXPECT_TRUE(has(emit("asm"), "ret"));
}

TEST_F(CompileVerb, OutputGoesToAFileWholeOrNotAtAll) {
    const std::string good = folder_.write("good.sl", tinted);
    const std::string bad = folder_.write("bad.sl", "surface b() { Ci = frob; }");
    const std::string out = folder_.path("out.ir");
    const Outcome run = compile({good, "--emit", "ir", "-o", out});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(run.out, "");
    const std::string whole = folder_.read("out.ir");
    EXPECT_EQ(whole, compile({good, "--emit", "ir"}).out);
    EXPECT_EQ(compile({good, bad, "--emit", "ir", "-o", out}).status, 1);
    EXPECT_EQ(folder_.read("out.ir"), whole);
    EXPECT_EQ(compile({good, "--emit", "ir", "-o", folder_.path("no/such/folder.ir")}).status, 1);
    EXPECT_EQ(compile({good, "--quiet", "-o", folder_.path("unused")}).status, 0);
}

/// Beyond the limit writing fails as on a full disk.
TEST_F(CompileVerb, OutputThatIsLostIsAnError) {
    const std::string file = folder_.write("tinted.sl", tinted);
    RunSettings full;
    full.fileSizeLimit = 1024;
    const Outcome run = runCandela({"compile", file, "--emit", "ir"}, full);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("cannot write to standard output")) << run.err;
    const std::string out = folder_.path("out.ir");
    const Outcome written = runCandela({"compile", file, "--emit", "ir", "-o", out}, full);
    EXPECT_EQ(written.status, 1) << written.text();
    EXPECT_TRUE(written.says("out.ir: File too large")) << written.err;
    EXPECT_FALSE(folder_.has("out.ir"));
    const std::string pipe =
        folder_.path("pipe"); // As a device, nothing to put a file in place of.
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const Outcome device = compile({file, "--emit", "ir", "-o", pipe});
    EXPECT_EQ(device.status, 1) << device.text();
    EXPECT_TRUE(device.says("not a regular file")) << device.err;
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));
    full.fileSizeLimit = 8;
    EXPECT_EQ(runCandela({"--version"}, full).status, 1);
}

/// What the cache cannot keep is made anew each time.
TEST_F(CompileVerb, DoesWithoutACacheThatIsFull) {
    const char *cache = std::getenv("CANDELA_CACHE");
    const std::string before = cache ? cache : "";
    setenv("CANDELA_CACHE", folder_.path("cache").c_str(), 1);
    RunSettings full;
    full.fileSizeLimit = 256; // Less than any object has.
    const Outcome run = runCandela({"compile", folder_.write("tinted.sl", tinted)}, full);
    cache ? setenv("CANDELA_CACHE", before.c_str(), 1) : unsetenv("CANDELA_CACHE");
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(has(run.out, "surface tinted")) << run.text();
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path("cache")));
}

TEST_F(CompileVerb, DefinesNamesAlone) {
    const std::string file = folder_.write("tinted.sl", tinted);
    for (const char *wrong : {"=", "1x=2", "A B", "F(x)=x", "A-B=1", "\xc3\xa9"}) {
        const Outcome run = compile({file, "-D", wrong});
        EXPECT_EQ(run.status, 2) << wrong << run.text();
        EXPECT_TRUE(run.says("expected NAME or NAME=VALUE")) << run.err;
    }
    EXPECT_EQ(compile({file, "-D", "_a1=", "-D", "B==", "-DC"}).status, 0);
}

TEST_F(CompileVerb, FilesThatHoldNoShader) {
    for (const char *text : {"", "/* nothing */\n", "float f() { return 1; }"}) {
        const Outcome run = compile({folder_.write("none.sl", text)});
        EXPECT_EQ(run.status, 1);
        EXPECT_TRUE(run.says("none.sl:1:1: error: the file holds no shader")) << run.err;
    }
    EXPECT_TRUE(compile({"/proc/self/mem"}).says("/proc/self/mem\": Input/output error"));
    EXPECT_TRUE(compile({"/dev/zero"}).says("/dev/zero\": it has more than 16777216 bytes"));
    EXPECT_TRUE(compile({folder_.path()}).says("Is a directory"));
}

TEST_F(CompileVerb, NamesOfAnyLengthAndKindInMessages) {
    const auto errorsOf = [&](const std::string &expression) {
        const Outcome run =
            compile({folder_.write("odd.sl", "surface odd() { Ci = " + expression + "; }")});
        EXPECT_EQ(run.status, 1);
        EXPECT_TRUE(run.says("odd.sl:1:22: error: ")) << run.err.substr(0, 9999);
        return run.err;
    };
    EXPECT_LT(errorsOf(std::string(1 << 20, 'x')).size(), 9999u);
    const std::string stray = errorsOf("\x1b[2J");
    EXPECT_FALSE(has(stray, "\x1b"));
    EXPECT_TRUE(has(stray, "Ci = \\x1b[2J")) << stray;
}

TEST_F(CompileVerb, StandardInput) {
    const Outcome run = compile({"-"}, folder_.write("in.sl", tinted));
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(has(run.out, "surface tinted")) << run.out;
}

} // namespace candela::test
