// SPDX-License-Identifier: Apache-2.0
// What can be wrong with files and with the command line.
#include "tests/bad_input/bad_input.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace candela::test {

namespace {

bool crashed(const Outcome &run) { return run.signal != 0 || run.status > 2 || run.status < 0; }

} // namespace

TEST_F(BadInput, MissingRibFile) {
    Outcome run = runCandela({folder_.path("nosuch.rib"), "--output-dir", folder_.path()});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("nosuch.rib")) << run.text();
}

TEST_F(BadInput, RibFileThatIsAFolder) {
    Outcome run = runCandela({folder_.path(), "--output-dir", folder_.path()});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says(folder_.path())) << run.text();
}

TEST_F(BadInput, EmptyFile) {
    Outcome run = render("");
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("no WorldBegin")) << run.text();
    EXPECT_FALSE(folder_.has("out.exr"));
}

TEST_F(BadInput, BinaryGarbage) {
    std::string garbage;
    unsigned state = 12345; // any fixed sequence of bytes
    for (int i = 0; i < 4096; ++i) {
        state = state * 1664525u + 1013904223u;
        garbage += char(state >> 24);
    }
    Outcome run = render(garbage);
    EXPECT_EQ(run.status, 1) << run.signal;
    EXPECT_TRUE(run.says("scene.rib:")) << run.text();
}

// Cut anywhere, a file is an error or a smaller scene, and never a crash.
TEST_F(BadInput, EveryNinetySeventhPrefix) {
    std::string rib = contentOf(CANDELA_SOURCE_DIR "/tests/determinism/everything.rib");
    ASSERT_GT(rib.size(), 1000u);
    for (std::size_t length = 97; length < rib.size(); length += 97) {
        Outcome run =
            render(rib.substr(0, length), {"--spp", "1", "--format", "16x12", "--shader-path",
                                           CANDELA_SOURCE_DIR "/tests/determinism/shaders"});
        ASSERT_FALSE(crashed(run)) << "cut after " << length << " bytes\n" << run.text();
    }
}

TEST_F(BadInput, TruncatedGzip) {
    folder_.write("scene.rib", std::string("\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03\x4b\x4c", 12));
    Outcome run = runCandela({folder_.path("scene.rib"), "--output-dir", folder_.path()});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("scene.rib")) << run.text();
}

// A regular file stands where a folder should be: not even root can write below it.
TEST_F(BadInput, OutputBelowARegularFile) {
    std::string file = folder_.write("file", "in the way");
    Outcome run =
        runCandela({folder_.write("scene.rib", sceneWith("")), "--output-dir", file + "/pictures"});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("scene.rib:4")) << run.text();
    EXPECT_TRUE(run.says("cannot write")) << run.text();
    EXPECT_EQ(folder_.read("file"), "in the way");
}

// One display cannot be written, the other still is.
TEST_F(BadInput, OneOfTwoDisplaysCannotBeWritten) {
    folder_.write("file", "in the way");
    std::string rib = sceneWith("");
    rib.insert(rib.find("Option"), "Display \"+file/other.exr\" \"openexr\" \"rgb\"\n");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("other.exr")) << run.text();
    expectDisc();
}

TEST_F(BadInput, OutputOutsideTheFolderNeedsTrust) {
    ScratchFolder elsewhere;
    std::string rib = sceneWith("");
    rib.replace(rib.find("out.exr"), 7, elsewhere.path("out.exr"));
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("need --trust")) << run.text();
    EXPECT_FALSE(elsewhere.has("out.exr"));
    EXPECT_TRUE(folder_.has("out.exr")) << "by its last name, in the output folder";
    EXPECT_EQ(render(rib, {"--trust"}).status, 0);
    EXPECT_TRUE(elsewhere.has("out.exr"));
}

// Pictures and textures of a stranger's file replace pictures alone. (image's own tests have the
// table.)
TEST_F(BadInput, WhatIsNoPictureIsNotReplacedWithoutTrust) {
    folder_.write("ramp.exr", "P1 1 1 0");
    const std::string notes = folder_.write("notes.txt", "the work of a year");
    std::string rib = sceneWith("");
    rib.replace(rib.find("out.exr"), 7, "notes.txt");
    for (const std::string &orders :
         {rib, "MakeTexture \"ramp.exr\" \"notes.txt\" \"black\" \"black\" \"box\" 1 1\n" +
                   sceneWith("")}) {
        Outcome run = render(orders);
        EXPECT_EQ(run.status, 1) << run.text();
        EXPECT_TRUE(run.says("notes.txt: it is there and no picture")) << run.text();
        EXPECT_EQ(folder_.read("notes.txt"), "the work of a year");
    }
    EXPECT_EQ(render(rib, {"--trust"}).status, 0);
    EXPECT_NE(folder_.read("notes.txt"), "the work of a year");
    folder_.write("notes.txt", "the work of a year");
    Outcome own = render(sceneWith(""), {"-o", notes}); // Who runs the program may do as they like.
    EXPECT_EQ(own.status, 0) << own.text();
    EXPECT_NE(folder_.read("notes.txt"), "the work of a year");
}

// Files that are named by a stranger's file are not shown to whoever reads the messages.
TEST_F(BadInput, WhatIsNeitherRibNorShaderIsNotQuoted) {
    const std::string word = "Tr0ub4dor";
    const std::string secret =
        folder_.write("secret", word + ":$6$" + word + ":" + word + "\n" + word);
    const std::string list =
        folder_.write("list.conf", "# " + word + "\n" + word + " = " + word + "\n");
    const std::string numbers = folder_.write("numbers", "127.0.0.1" + word + "\n");
    folder_.write("nosy.sl", "#include \"" + secret + "\"\nsurface nosy() { Ci = 1; }");
    for (const std::string &line :
         {"ReadArchive \"" + secret + "\"", "ReadArchive \"" + list + "\"",
          "ReadArchive \"" + numbers + "\"",
          "Procedural \"DelayedReadArchive\" [\"" + secret + "\"] [-1 1 -1 1 -1 1]"}) {
        Outcome run = render(sceneWith(line));
        EXPECT_EQ(run.status, 1) << run.text();
        EXPECT_TRUE(run.says("this is no RIB")) << run.text();
        EXPECT_FALSE(run.says(word)) << run.text();
    }
    Outcome run = render(sceneWith("Surface \"nosy\""), {"--shader-path", folder_.path()});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_FALSE(run.says("$6$")) << run.text();
    folder_.write("slip.rib", "Color [1 0 0] Speher 1"); // Named as RIB is: its slips are told.
    run = render(sceneWith("ReadArchive \"slip.rib\""));
    EXPECT_TRUE(run.says("'Speher'")) << run.text();
    folder_.write("bare", "# a comment\r\r\n Color [1 0 0]");
    EXPECT_EQ(render(sceneWith("ReadArchive \"bare\"")).status, 0);
}

TEST_F(BadInput, WhatTheEnvironmentHoldsIsNotTold) {
    ::setenv("CANDELA_TEST_SECRET", "Tr0ub4dor", 1);
    Outcome run = render("Option \"searchpath\" \"string shader\" \"${CANDELA_TEST_SECRET}/a:@\"\n"
                         "Option \"searchpath\" \"string archive\" \"%CANDELA_TEST_SECRET%\"\n" +
                         sceneWith("Surface \"none\"\nReadArchive \"none.rib\""));
    ::unsetenv("CANDELA_TEST_SECRET");
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("no shader \"none\"")) << run.text();
    EXPECT_FALSE(run.says("Tr0ub4dor")) << run.text();
}

// Whole or not at all: a full disk leaves no broken picture, and an older one stays.
TEST_F(BadInput, DiskFull) {
    const std::string older = "v/1\x01 an older picture";
    folder_.write("out.exr", older);
    RunSettings full;
    full.fileSizeLimit = 2048;
    Outcome run = render(sceneWith(""), {"--format", "200x200"}, full);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("out.exr")) << run.text();
    EXPECT_EQ(folder_.read("out.exr"), older);
    auto files = std::filesystem::directory_iterator(folder_.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 2) << "something was left behind";
}

// Files that are there and fail while they are read, as those of bad disks and lost servers.
TEST_F(BadInput, FilesThatCannotBeReadToTheirEnd) {
    for (const char *file : {"/proc/self/mem", "/proc/self/pagemap"}) {
        folder_.write("eio.sl",
                      "#include \"" + std::string(file) + "\"\nsurface eio() { Ci = 0; Oi = 1; }");
        Outcome run = render(sceneWith("Surface \"eio\""), {"--shader-path", folder_.path()});
        EXPECT_EQ(run.status, 1) << run.text();
        EXPECT_TRUE(run.says("eio.sl:1:10: error: cannot read " + std::string(file))) << run.text();
        EXPECT_TRUE(folder_.has("out.exr"));
    }
    expectReportedAndRendered("ReadArchive \"/proc/self/mem\"", {"Input/output error"});
    Outcome run = runCandela({"/proc/self/mem"});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("Input/output error")) << run.text();
    run = runCandela({"diff", "/proc/self/mem", "/proc/self/mem"});
    EXPECT_EQ(run.status, 2) << run.text();
    EXPECT_TRUE(run.says("Input/output error")) << run.text();
}

TEST_F(BadInput, NamesOfAnyLengthAndKind) {
    const std::string name = "\x1b[2J\x07" + std::string(1 << 20, 'x');
    Outcome run = render(sceneWith("Surface \"" + name + "\""));
    EXPECT_LT(run.err.size(), 9999u);
    EXPECT_FALSE(run.says("\x1b")) << run.text();
    EXPECT_TRUE(run.says("\\x1b[2J\\x07xx")) << run.text();
}

TEST_F(BadInput, UnknownDisplayType) {
    std::string rib = sceneWith("");
    rib.replace(rib.find("\"openexr\""), 9, "\"hologram\"");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("scene.rib:4:1: warning")) << run.text();
    EXPECT_TRUE(run.says("hologram")) << run.text();
    expectDisc();
}

// Said at once, and not after a night: a billion samples would take longer than a test may.
TEST_F(BadInput, FramesWithoutAPictureAreNotRendered) {
    for (const char *display : {"\"../\" \"file\" \"rgb\"", "\"out.exr\" \"file\" \"nonsense\"",
                                "\"out.png\" \"png\" \"rgbaz\""}) {
        std::string rib = sceneWith("");
        rib.replace(rib.find("\"out.exr"), 26, display);
        Outcome run = render(rib, {"--spp", "16777216", "--format", "4000x4000"});
        EXPECT_EQ(run.status, 1) << run.text();
        EXPECT_TRUE(run.says("scene.rib:4:1: error")) << run.text();
    }
}

TEST_F(BadInput, PictureLargerThanTheMachine) {
    std::string rib = sceneWith("");
    rib.replace(rib.find("Format 8 8 1"), 12, "Format 1000000 1000000 1");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("scene.rib:2:1: error: a picture of 1000000 x 1000000 pixels takes"))
        << run.text();
    EXPECT_EQ(render(rib, {"--crop", "0,0.00001,0,0.00001"}).status, 0);
}

TEST_F(BadInput, CropWindowWithinAPixel) {
    std::string rib = sceneWith("");
    rib.insert(rib.find("Option"), "CropWindow 0.13 0.14 0 1\n");
    Outcome run = render(rib);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("scene.rib:5:1: error: the crop window holds no pixel")) << run.text();
    run = render(sceneWith(""), {"--crop", "0.13,0.14,0,1"});
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("the crop window holds no pixel")) << run.text();
}

TEST_F(BadInput, ProgramWithoutItsShaders) {
    RunSettings settings;
    settings.program = folder_.path("candela");
    std::filesystem::copy_file(candelaProgram(), settings.program);
    const char *shaders = std::getenv("CANDELA_SHADERS");
    std::string before = shaders ? shaders : "";
    unsetenv("CANDELA_SHADERS");
    Outcome run = render(sceneWith("Sphere 1 -1 1 360"), {}, settings);
    if (shaders)
        setenv("CANDELA_SHADERS", before.c_str(), 1);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("\"constant\"")) << run.text();
    EXPECT_TRUE(run.says("CANDELA_SHADERS")) << run.text();
    EXPECT_TRUE(folder_.has("out.exr"));
}

TEST_F(BadInput, OptionsThatCannotBeUnderstood) {
    std::string rib = folder_.write("scene.rib", sceneWith(""));
    const std::vector<std::vector<std::string>> wrong{{rib, "--nosuchoption"},
                                                      {rib, "--spp", "0"},
                                                      {rib, "--spp", "many"},
                                                      {rib, "--format", "640"},
                                                      {rib, "--format", "0x480"},
                                                      {rib, "--crop", "0,1"},
                                                      {rib, "--crop", "1,0,0,1"},
                                                      {rib, "--lanes", "3"},
                                                      {rib, "--integrator", "magic"},
                                                      {rib, "--sampling", "sphere"},
                                                      {rib, "--threads", "-1"},
                                                      {rib, "--frames", "two"},
                                                      {rib, "--time-limit", "-1"},
                                                      {rib, "--every", "0"},
                                                      {"diff"},
                                                      {"diff", "a.exr"}};
    for (const auto &arguments : wrong) {
        Outcome run = runCandela(arguments, {.folder = folder_.path()});
        EXPECT_EQ(run.status, 2) << arguments.back() << "\n" << run.text();
        EXPECT_NE(run.err, "") << arguments.back();
        EXPECT_FALSE(folder_.has("out.exr"));
    }
}

} // namespace candela::test
