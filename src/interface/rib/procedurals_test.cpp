// SPDX-License-Identifier: Apache-2.0
// Procedural primitives: archives, and programs that answer, die, hang and flood.
#include "interface/rib/reading_fixture.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace candela::testing {

namespace fs = std::filesystem;

class Procedurals : public Reading {
protected:
    const fs::path folder = fs::path(CANDELA_BINARY_DIR) /
                            ("procedurals_test." + std::to_string(::getpid()) + "." +
                             ::testing::UnitTest::GetInstance()->current_test_info()->name());
    ProceduralSettings procedurals{true, {2, 4, 1 << 20}};

    void SetUp() override { fs::create_directories(folder); }
    void TearDown() override { fs::remove_all(folder); }

    void program(const std::string &name, const std::string &script) {
        std::ofstream(folder / name) << "#!/bin/sh\ncd " << folder.string() << "\n"
                                     << script << "\n";
        fs::permissions(folder / name, fs::perms::owner_all);
    }
    void file(const std::string &name, const std::string &text) {
        std::ofstream(folder / name) << text;
    }
    std::string content(const std::string &name) const {
        std::ifstream in(folder / name);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    /// What a world with this content holds.
    const ListeningSceneBuilder::World &drawn(const std::string &content) {
        ErrorPolicy policy(found);
        GraphicsState state(builder, shaders, policy, settings);
        RibReader(state, policy, procedurals)
            .readText("Format 100 100 1 ScreenWindow -1 1 -1 1\n"
                      "Option \"searchpath\" \"string procedural\" [\"" +
                          folder.string() +
                          "\"]\n"
                          "Option \"searchpath\" \"string archive\" [\"" +
                          folder.string() +
                          "\"]\n"
                          "WorldBegin\n" +
                          content + "\nWorldEnd\n",
                      "test.rib");
        state.finish();
        return builder.worlds.back();
    }
};

const std::string askMaker =
    "Procedural \"RunProgram\" [\"maker\" \"one two\"] [-.1 .1 -.1 .1 0 0]\n";

TEST_F(Procedurals, archivesAreReadInTheirPlaceAndChangeNothingAroundThem) {
    file("ball.rib", "Color 1 0 0 Translate 0 1 0 Sphere 1 -1 1 360");
    const auto &world =
        drawn("Translate 2 0 0\n"
              "Procedural \"DelayedReadArchive\" [\"ball.rib\"] [-1 1 0 2 -1 1]\n"
              "Disk 0 1 360\n"
              "Procedural2 \"DelayedReadArchive2\" \"SimpleBound\" \"string filename\" "
              "[\"ball.rib\"] \"float[6] bound\" [-1 1 0 2 -1 1]\n"
              "ArchiveBegin \"inner\" Cone 1 1 360 ArchiveEnd\n"
              "Procedural \"DelayedReadArchive\" [\"inner\"] [0 1 0 1 0 1]");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(world.primitives.size(), 4u);
    EXPECT_EQ(world.primitives[0].attributes->color, Color(1, 0, 0));
    EXPECT_EQ(world.primitives[0].place(0, 0, 0), (Vec3{2, 1, 0}));
    EXPECT_EQ(world.primitives[1].attributes->color, Color(1));
    EXPECT_EQ(world.primitives[1].place(0, 0, 0), (Vec3{2, 0, 0}));
    EXPECT_EQ(world.primitives[2].place(0, 0, 0), (Vec3{2, 1, 0}));
}

TEST_F(Procedurals, standInObjectsConditionsAndArchives) {
    file("ball.rib", "Sphere 1 -1 1 360");
    const std::string ball = "Procedural \"DelayedReadArchive\" [\"ball.rib\"] [-1 1 -1 1 -1 1]\n";
    const auto &world = drawn("ObjectBegin 1 " + ball +
                              "ObjectEnd ObjectInstance 1\n"
                              "IfBegin \"0\" " +
                              ball +
                              "Procedural \"Nothing\" [] [] IfEnd\n"
                              "ArchiveBegin \"a\" " +
                              ball + ball + "ArchiveEnd ReadArchive \"a\"");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(world.objects.at(0).primitives.size(), 1u);
    EXPECT_EQ(world.primitives.size(), 2u);
}

TEST_F(Procedurals, programsAnswerLineByLine) {
    program("maker", "echo start >> started\nwhile read line; do echo \"$line\" >> asked\n"
                     "printf 'Sphere 1 -1 1 360 Color 1 0 0\\n\\377'; done");
    const auto &world =
        drawn(askMaker + "Disk 0 1 360\nScale 2 2 2\n" + askMaker +
              "Procedural \"RunProgram\" [\"maker with arguments\" \"x\"] [0 1 0 1]\n");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(world.primitives.size(), 4u);
    EXPECT_EQ(world.primitives[1].attributes->color, Color(1));
    EXPECT_EQ(content("started"), "start\nstart\n"); // One a command.
    // A tenth of the window is ten pixels wide; twice as wide four times the area.
    EXPECT_EQ(content("asked").substr(0, 51),
              "100.000000 one two\n400.000000 one two\n1000000015047");
}

// Unpacked from some archives scripts are not executable.
TEST_F(Procedurals, scriptsNeedNoPermission) {
    program("maker", "read line; echo Sphere 1 -1 1 360");
    fs::permissions(folder / "maker", fs::perms::owner_read);
    EXPECT_EQ(drawn(askMaker).primitives.size(), 1u);
    EXPECT_EQ(found.text(), "");
}

TEST_F(Procedurals, programsMayEndInsteadOfMarkingTheEnd) {
    program("maker", "read line; echo Sphere 1 -1 1 360");
    EXPECT_EQ(drawn(askMaker + askMaker).primitives.size(), 2u);
    EXPECT_EQ(found.text(), "");
}

TEST_F(Procedurals, programsMayAskForThemselves) {
    program("maker",
            "while read detail n; do\n"
            "[ $n -gt 0 ] && printf 'Procedural \"RunProgram\" [\"maker\" \"%d\"] []\\n' $((n-1))\n"
            "printf 'Sphere 1 -1 1 360\\n\\377'; done");
    EXPECT_EQ(drawn("Procedural \"RunProgram\" [\"maker\" \"3\"] []").primitives.size(), 4u);
    EXPECT_EQ(found.text(), "");
}

TEST_F(Procedurals, nothingRunsWithoutTrust) {
    procedurals.trusted = false;
    program("maker", "touch ran; read line; echo Sphere 1 -1 1 360");
    EXPECT_EQ(drawn(askMaker + askMaker + "Disk 0 1 360").primitives.size(), 1u);
    EXPECT_EQ(errors(), 1); // Once.
    EXPECT_TRUE(says("test.rib:5:1: error: RunProgram: 'maker': files run programs with --trust"));
    EXPECT_FALSE(fs::exists(folder / "ran"));
}

TEST_F(Procedurals, badProgramsAreEndedAndTheRestIsRead) {
    const struct {
        const char *name, *script, *message;
        std::size_t spheres;
    } cases[] = {
        {"dies", "read line; echo Sphere 1 -1 1 360; exit 3", "ended with exit status 3", 2},
        {"is killed", "kill -9 $$", "ended by signal 9", 0},
        {"hangs", "sleep 100", "said nothing for 2 seconds", 0},
        {"drips", "while true; do printf ' '; sleep 1; done",
         "not finished its answer in 4 seconds", 0},
        {"floods",
         "while true; do echo '                                                    '; done",
         "more than 1048576 bytes", 0},
        {"closes", "exec >&-; sleep 100", "closed its output and goes on", 0},
        {"is deaf", "exec <&-; printf '\\377'; sleep 100", "", 0},
        {"speaks badly", "read line; printf 'Foo 1 Sphere 1 -1 1 360\\n\\377'; read line", "'Foo'",
         1},
        {"leaves a child", "sleep 100 & read line; printf 'Sphere 1 -1 1 360\\n\\377'; read line",
         "", 1},
    };
    for (const auto &each : cases) {
        program("maker", each.script);
        const auto start = std::chrono::steady_clock::now();
        const auto &world = drawn(askMaker + askMaker + "Disk 0 1 360");
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(world.primitives.size(), each.spheres + 1) << each.name << "\n" << found.text();
        EXPECT_TRUE(says(each.message)) << each.name << "\n" << found.text();
        EXPECT_TRUE(world.ended) << each.name;
        EXPECT_LT(passed.count(), 30) << each.name;
    }
}

TEST_F(Procedurals, whatIsWrongIsReported) {
    const struct {
        const char *request, *message;
    } cases[] = {
        {"Procedural \"Sorcery\" [\"a\"] []", "Procedural: 'Sorcery' is unknown"},
        {"Procedural \"RunProgram\" [] []", "expected the name of a program"},
        {"Procedural \"DelayedReadArchive\" [] []", "expected the name of an archive"},
        {"Procedural \"DelayedReadArchive\" [\"no.rib\"] []",
         "DelayedReadArchive: there is no archive 'no.rib'"},
        {"Procedural \"RunProgram\" [\"none\" \"\"] []",
         "RunProgram: 'none': there is no such file"},
        {"Procedural \"RunProgram\" [\"\" \"\"] []", "there is no such file"},
        {"Procedural \"RunProgram\" [\"plain\" \"\"] []", "RunProgram: 'plain': Permission denied"},
        {"Procedural2 \"Sorcery\" \"SimpleBound\"", "Procedural2: 'Sorcery' is unknown"},
        {"Procedural2 \"DelayedReadArchive2\" \"SimpleBound\"", "expected \"string filename\""},
    };
    file("plain", "no program");
    for (const auto &each : cases) {
        EXPECT_EQ(drawn(std::string(each.request) + "\nDisk 0 1 360").primitives.size(), 1u);
        EXPECT_TRUE(says(each.message)) << each.request << "\n" << found.text();
    }
    EXPECT_EQ(errors(), int(std::size(cases)));
}

TEST_F(Procedurals, thatReadThemselvesEnd) {
    file("self.rib", "Procedural \"DelayedReadArchive\" [\"self.rib\"] []");
    program("maker", "while read line; do\n"
                     "printf 'Procedural \"RunProgram\" [\"maker\" \"\"] []\\n\\377'; done");
    drawn("Procedural \"DelayedReadArchive\" [\"self.rib\"] []\n"
          "Procedural \"RunProgram\" [\"maker\" \"\"] []\nDisk 0 1 360");
    EXPECT_EQ(errors(), 2);
    EXPECT_TRUE(says("would read itself without end"));
    EXPECT_TRUE(says("nested more than 64 deep"));
}

} // namespace candela::testing
