// SPDX-License-Identifier: Apache-2.0
#include "image/displays.h"

#include "foundation/base/whole_file.h"
#include "image/exr_file.h"
#include "image/imaging.h"
#include "image/png_file.h"
#include "world/texture/module.h"

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/resource.h>

namespace candela {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end.
class DisplaysTest : public testing::Test {
protected:
    DisplaysTest() {
        std::string pattern = (fs::temp_directory_path() / "candela_display_XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        policy_.folder.directory = folder_;
        options_.filter = {"box", 1, 1};
        frame_.metadata = {{"renderer", "candela test"}, {"spp", "1"}};
    }
    ~DisplaysTest() override { fs::remove_all(folder_); }

    void display(const std::string &name, const std::string &type, const std::string &mode) {
        DisplayRecord record;
        record.name = name;
        record.type = type;
        record.mode = mode;
        options_.displays.push_back(record);
    }

    /// A film of 4 x 3 pixels, a crop of a frame of 6 x 5, with one sample a pixel.
    void fill(bool halves = false) {
        available_ = {{"z", 1}, {"N", 3}, {"albedo", 3}, {"id", 1}};
        Film::Settings settings;
        settings.window = {6, 5, 1, 5, 2, 5};
        settings.channels = wantedChannels(options_.displays, available_);
        settings.keepHalves = halves;
        film_.emplace(settings);
        for (int y = 2; y < 5; ++y)
            for (int x = 1; x < 5; ++x)
                addPixel(x, y);
    }
    void addPixel(int x, int y) {
        std::vector<float> values;
        std::vector<const float *> planes;
        int k = 0;
        for (const ChannelInfo &channel : film_->channels())
            for (int c = 0; c < channel.components; ++c)
                values.push_back(valueAt(x, y, k++));
        for (const float &value : values)
            planes.push_back(&value);
        const int index = 0;
        const float weight = 1;
        film_->add({1, &x, &y, &index, &weight, planes.data()});
    }
    /// Component k of the film at a pixel: exact in float, within [0, 1).
    static float valueAt(int x, int y, int k) { return float((x * 7 + y * 13 + k * 29) % 64) / 64; }
    std::vector<PlannedDisplay> plan() {
        return planDisplays(options_, available_, policy_, list_);
    }
    std::vector<std::string> writeAll() {
        return writeDisplays(*film_, plan(), options_, frame_, list_);
    }
    Picture readExr(const std::string &name) {
        std::string problem;
        const auto bytes = readWholeFile((fs::path(folder_) / name).string(), problem);
        const auto picture = decodeExr(bytes.value_or(""), problem);
        EXPECT_TRUE(picture) << problem;
        return picture.value_or(Picture{});
    }
    Picture readPng(const std::string &name) {
        std::string problem;
        const auto bytes = readWholeFile((fs::path(folder_) / name).string(), problem);
        const auto picture = decodePng(bytes.value_or(""), problem);
        EXPECT_TRUE(picture) << problem;
        return picture.value_or(Picture{});
    }
    int fileCount() const {
        return int(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    std::string folder_;
    OutputPolicy policy_;
    Options options_;
    FrameDescription frame_;
    std::vector<ChannelInfo> available_;
    std::optional<Film> film_;
    DiagnosticList list_;
};

TEST_F(DisplaysTest, ExrHoldsChannelsWindowAndDescription) {
    display("a.exr", "openexr", "rgbaz,N,radiance");
    options_.exposure = {2, 1};
    options_.named["radiometry:units"] = {"units", {}, {}, {"si"}};
    frame_.worldToCamera = translation(1, 2, 3);
    fill();
    ASSERT_EQ(writeAll().size(), 1u) << list_.text();
    const Picture picture = readExr("a.exr");
    EXPECT_EQ(picture.window, film_->window());
    EXPECT_EQ(picture.metadata.at("units"), "W m^-2 sr^-1");
    EXPECT_EQ(picture.metadata.at("luminousEfficacy"), "179 lm/W");
    EXPECT_EQ(picture.metadata.at("exposure"), "2 1");
    EXPECT_EQ(picture.metadata.at("pixelFilter"), "box 1 1");
    EXPECT_EQ(picture.metadata.at("renderer"), "candela test");
    EXPECT_EQ(picture.worldToCamera, translation(1, 2, 3));
    std::size_t i = 0;
    for (int y = 2; y < 5; ++y)
        for (int x = 1; x < 5; ++x, ++i) {
            for (int c = 0; c < 3; ++c) {
                const std::string letter(1, "RGB"[c]);
                ASSERT_EQ(picture.find(letter)->values[i], 2 * valueAt(x, y, c));
                ASSERT_EQ(picture.find("radiance." + letter)->values[i], valueAt(x, y, c));
                ASSERT_EQ(picture.find(std::string("N.") + "XYZ"[c])->values[i],
                          valueAt(x, y, 7 + c));
            }
            const double alpha =
                (double(valueAt(x, y, 3)) + valueAt(x, y, 4) + valueAt(x, y, 5)) / 3;
            ASSERT_NEAR(picture.find("A")->values[i], alpha, 1e-6);
            ASSERT_EQ(picture.find("Z")->values[i], valueAt(x, y, 6));
        }
}

TEST_F(DisplaysTest, PngQuantisesWithTheDocumentedDither) {
    display("a.png", "png", "rgb");
    options_.exposure = {1, 2};
    fill();
    ASSERT_EQ(writeAll().size(), 1u) << list_.text();
    const Picture picture = readPng("a.png");
    ASSERT_EQ(picture.channels.size(), 3u);
    EXPECT_EQ(picture.metadata.at("units"), "relative");
    EXPECT_FALSE(picture.metadata.contains("luminousEfficacy"));
    std::size_t i = 0;
    for (int y = 2; y < 5; ++y)
        for (int x = 1; x < 5; ++x, ++i)
            for (int c = 0; c < 3; ++c) {
                const double exact = 255 * std::sqrt(valueAt(x, y, c));
                const int level = int(std::lround(picture.channels[c].values[i] * 255));
                EXPECT_NEAR(level, exact, 1.001);
                EXPECT_EQ(level, int(quantized(exposed(valueAt(x, y, c), {1, 2}), eightBitQuantize,
                                               ditherNoise(x, y, c))));
            }
}

/// The bytes of a chunk of a PNG file; none if it has no such chunk.
std::string chunkOf(const std::string &png, const std::string &type) {
    const std::size_t at = png.find(type);
    const auto byte = [&](std::size_t i) { return std::size_t((unsigned char)png[i]); };
    return at == std::string::npos || at < 4 ? ""
                                             : png.substr(at + 4, byte(at - 2) << 8 | byte(at - 1));
}

TEST_F(DisplaysTest, PngIsSrgbWhereNobodySaysOtherwise) {
    const QuantizeRecord plain{255, 0, 255, 0};
    const struct {
        const char *type, *mode;
        std::optional<ExposureRecord> exposure;
        std::optional<QuantizeRecord> own, all;
        bool isSrgb;
        std::uint32_t gamma;
    } table[] = {
        {"png", "rgb", {}, {}, {}, true, 45455},
        {"file", "rgb", {}, {}, {}, true, 45455},
        {"png", "rgba", {}, {}, {}, true, 45455},
        {"png", "rgb", ExposureRecord{1, 1}, {}, {}, false, 100000},
        {"png", "rgb", ExposureRecord{1, 2.2f}, {}, {}, false, 45455},
        {"png", "rgb", ExposureRecord{2, 1.8f}, {}, {}, false, 55556},
        {"png", "rgb", {}, plain, {}, false, 100000},
        {"png", "rgb", {}, {}, plain, false, 100000},
        {"png", "albedo", {}, {}, {}, false, 100000}, // No light.
    };
    for (const auto &row : table) {
        options_ = {};
        options_.filter = {"box", 1, 1};
        display("a.png", row.type, row.mode);
        options_.displays[0].quantize = row.own;
        options_.colorQuantize = row.all;
        options_.exposure = row.exposure;
        fill();
        ASSERT_EQ(writeAll().size(), 1u) << list_.text();
        std::string problem;
        const std::string bytes = *readWholeFile(folder_ + "/a.png", problem);
        EXPECT_EQ(!chunkOf(bytes, "sRGB").empty(), row.isSrgb);
        const std::string gamma = chunkOf(bytes, "gAMA");
        ASSERT_EQ(gamma.size(), 4u);
        std::uint32_t stored = 0;
        for (const char byte : gamma)
            stored = stored << 8 | (unsigned char)byte;
        EXPECT_EQ(stored, row.gamma);
    }
}

TEST_F(DisplaysTest, PngHasTheColorOfWhatCoversThePixel) {
    const QuantizeRecord fine{65535, 0, 65535, 0};
    for (const float gamma : {1.0f, 2.0f}) {
        options_ = {};
        options_.filter = {"box", 1, 1};
        display("a.png", "png", "rgba");
        display("a.exr", "openexr", "rgba");
        options_.displays[0].quantize = fine;
        options_.exposure = {.25f, gamma};
        fill();
        ASSERT_EQ(writeAll().size(), 2u) << list_.text();
        const Picture straight = readPng("a.png"), whole = readExr("a.exr");
        EXPECT_EQ(straight.hasDisplayValues, gamma != 1);
        int compared = 0;
        for (std::size_t i = 0; i < whole.window.pixels(); ++i) {
            const float alpha = whole.find("A")->values[i];
            ASSERT_GT(alpha, 0);
            // Where the file says that it holds light, the reader has made it that of whole pixels.
            const float share = gamma == 1 ? 1 : std::pow(alpha, 1 / gamma);
            const float expected = whole.find("G")->values[i] / share;
            if (expected > .99f) // Clamped, perhaps.
                continue;
            ++compared;
            EXPECT_NEAR(straight.find("G")->values[i], expected, 2e-5f);
        }
        EXPECT_GT(compared, 3);
    }
}

TEST_F(DisplaysTest, SixteenBitsAndAlpha) {
    display("a.png", "file", "rgba");
    options_.displays[0].quantize = QuantizeRecord{65535, 0, 65535, 0};
    fill();
    ASSERT_EQ(writeAll().size(), 1u) << list_.text();
    const Picture picture = readPng("a.png");
    ASSERT_EQ(picture.channels.size(), 4u);
    EXPECT_NEAR(picture.find("G")->values[5], valueAt(2, 3, 1), 0.51 / 65535);
}

TEST_F(DisplaysTest, QuantizeAppliesToFloatFilesOnlyIfAsked) {
    display("plain.exr", "openexr", "rgb,albedo");
    display("whole.exr", "openexr", "rgb,albedo");
    options_.displays[1].quantize = QuantizeRecord{100, 10, 50, 0};
    fill();
    ASSERT_EQ(writeAll().size(), 2u) << list_.text();
    EXPECT_EQ(readExr("plain.exr").find("R")->values[0], valueAt(1, 2, 0));
    const Picture whole = readExr("whole.exr");
    const float level = std::floor(100 * valueAt(1, 2, 0) + 0.5f);
    EXPECT_EQ(whole.find("R")->values[0], std::clamp(level, 10.0f, 50.0f));
    EXPECT_EQ(whole.find("albedo.R")->values[0],
              std::clamp(std::floor(100 * valueAt(1, 2, 6) + 0.5f), 10.0f, 50.0f));
}

// Quantize names channels; a display's own numbers are for all of it, and say what 0 becomes.
TEST_F(DisplaysTest, ChannelsAreQuantizedIfAsked) {
    display("a.exr", "openexr", "rgb,albedo,id");
    display("b.exr", "openexr", "albedo");
    options_.displays[1].quantize = QuantizeRecord{128, 0, 255, 0, 64};
    options_.channelQuantize["albedo"] = QuantizeRecord{1000, 0, 255, 0};
    fill();
    ASSERT_EQ(writeAll().size(), 2u) << list_.text();
    const Picture a = readExr("a.exr"), b = readExr("b.exr");
    const float albedo = valueAt(1, 2, 6);
    EXPECT_EQ(a.find("R")->values[0], valueAt(1, 2, 0));
    EXPECT_EQ(a.find("albedo.R")->values[0], std::min(std::floor(1000 * albedo + .5f), 255.0f));
    EXPECT_EQ(b.find("albedo.R")->values[0], std::min(std::floor(1000 * albedo + .5f), 255.0f));
    options_.channelQuantize.clear();
    ASSERT_EQ(writeAll().size(), 2u) << list_.text();
    EXPECT_EQ(readExr("b.exr").find("albedo.R")->values[0], std::floor(64 + 64 * albedo + .5f));
}

// Numbers for the bytes of a framebuffer are not for the file that stands in for it.
TEST_F(DisplaysTest, StandInsAreNotQuantized) {
    display("window", "framebuffer", "rgb");
    options_.displays[0].quantize = QuantizeRecord{255, 0, 255, 0};
    options_.colorQuantize = QuantizeRecord{255, 0, 255, 0};
    fill();
    ASSERT_EQ(writeAll().size(), 1u) << list_.text();
    EXPECT_EQ(readExr("window.exr").find("R")->values[0], valueAt(1, 2, 0));
}

TEST_F(DisplaysTest, HalvesAreLayers) {
    display("a.exr", "openexr", "rgb,variance");
    Parameter parameter;
    parameter.name = "halfbuffers";
    parameter.floats = {1};
    options_.displays[0].parameters.all.push_back(parameter);
    ASSERT_TRUE(wantsHalves(options_.displays));
    fill(true);
    ASSERT_EQ(writeAll().size(), 1u) << list_.text();
    const Picture picture = readExr("a.exr");
    EXPECT_EQ(picture.find("half0.R")->values[0], valueAt(1, 2, 0));
    EXPECT_EQ(picture.find("half1.R")->values[0], 0); // No odd sample.
    EXPECT_TRUE(std::isinf(picture.find("variance.R")->values[0]));
    EXPECT_EQ(picture.find("half0.variance.R"), nullptr);
}

TEST_F(DisplaysTest, DefaultDisplayWhereNoneIsNamed) {
    fill();
    const auto written = writeAll();
    ASSERT_EQ(written.size(), 1u) << list_.text();
    EXPECT_EQ(fs::path(written[0]).filename(), "ri.exr");
}

TEST_F(DisplaysTest, OneBadDisplayDoesNotStopTheOthers) {
    display("b.exr", "openexr", "rgb,nonsense");
    display("c.png", "png", "z");
    display("d.png", "png", "rgba,id");
    display("good.exr", "openexr", "rgb");
    fill();
    EXPECT_EQ(writeAll().size(), 1u);
    EXPECT_EQ(list_.count(Severity::Error), 3);
    for (const char *part : {"\"nonsense\"; known are", "Quantize \"z\"", "not 5"})
        EXPECT_NE(list_.text().find(part), std::string::npos) << list_.text();
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(DisplaysTest, FileGoesByItsExtension) {
    display("a.PNG", "file", "rgb");
    display("b.exr", "file", "rgb");
    display("c", "file", "rgb");
    display("d.sgi", "file", "rgb");
    fill();
    EXPECT_EQ(writeAll().size(), 4u) << list_.text();
    EXPECT_EQ(list_.count(Severity::Warning), 1) << list_.text();
    readPng("a.PNG");
    for (const char *name : {"b.exr", "c"})
        EXPECT_EQ(readExr(name).channels.size(), 3u);
    EXPECT_TRUE(fs::exists(fs::path(folder_) / "d.sgi")); // TIFF, as "file" used to be.
}

/// A file read by the module of pictures, as its numbers are.
PictureData readNumbers(const std::string &path) {
    std::string problem;
    PictureLibrary *library = pictureLibrary(problem);
    EXPECT_TRUE(library) << problem;
    PictureData picture;
    if (library) {
        EXPECT_TRUE(library->read(path, PictureCurve::Linear, picture, problem)) << problem;
    }
    return picture;
}

TEST_F(DisplaysTest, TiffAndHdrHoldTheirNumbers) {
    std::string problem;
    options_.colorQuantize = QuantizeRecord{255, 0, 255, 0};
    display("bytes.tif", "TIFF", "rgba");
    display("words.tif", "file", "rgb");
    options_.displays.back().quantize = QuantizeRecord{65535, 0, 65535, 0};
    display("floats.tiff", "tiff", "rgb");
    options_.displays.back().quantize = QuantizeRecord{};
    display("depth.tif", "tiff", "z");
    display("normals.tif", "tiff", "N");
    display("light.hdr", "hdr", "rgba");
    fill();
    EXPECT_EQ(writeAll().size(), 6u) << list_.text();
    EXPECT_EQ(list_.text(), "");
    struct {
        const char *name;
        int channels;
        double tolerance;
        std::vector<std::string> planes;
    } files[] = {{"bytes.tif", 4, 0.5 / 255 + 1e-6, {"R", "G", "B", "A"}},
                 {"words.tif", 3, 0.5 / 65535 + 1e-6, {"R", "G", "B"}},
                 {"floats.tiff", 3, 0, {"R", "G", "B"}},
                 {"depth.tif", 1, 0, {"Z"}},
                 {"normals.tif", 3, 0, {"N.X", "N.Y", "N.Z"}},
                 {"light.hdr", 3, 1.0 / 128, {"R", "G", "B"}}};
    for (std::size_t i = 0; i < std::size(files); ++i) {
        const auto &[name, channels, tolerance, planes] = files[i];
        const PictureData read = readNumbers(folder_ + "/" + name);
        ASSERT_EQ(read.facts.channels, channels) << name;
        ASSERT_EQ(read.facts.width, 4) << name;
        ASSERT_EQ(read.facts.height, 3) << name;
        const Picture wanted = developPicture(*film_, plan()[i].planes, {});
        for (int c = 0; c < channels; ++c) {
            const PictureChannel *plane = wanted.find(planes[std::size_t(c)]);
            ASSERT_TRUE(plane) << name << planes[std::size_t(c)];
            for (std::size_t k = 0; k < 12; ++k)
                EXPECT_NEAR(read.values[k * std::size_t(channels) + std::size_t(c)],
                            plane->values[k], tolerance)
                    << name;
        }
    }
    const auto first = readWholeFile(folder_ + "/bytes.tif", problem);
    EXPECT_EQ(writeAll().size(), 6u);
    EXPECT_EQ(readWholeFile(folder_ + "/bytes.tif", problem), first);
}

TEST_F(DisplaysTest, HdrHoldsColorsAlone) {
    display("depth.hdr", "hdr", "z");
    display("both.hdr", "file", "rgb,N");
    fill();
    EXPECT_EQ(writeAll().size(), 0u);
    EXPECT_EQ(list_.count(Severity::Error), 2);
    EXPECT_NE(list_.text().find("holds three colors: its mode is \"rgb\""), std::string::npos)
        << list_.text();
}

// No picture is lost because its type is for a later version.
TEST_F(DisplaysTest, UnknownTypesBecomeOpenExr) {
    display("a.sgi", "sgi", "rgb");
    display("window", "framebuffer", "rgba");
    display("b.exr", "zfile", "z");
    fill();
    EXPECT_EQ(writeAll().size(), 3u) << list_.text();
    EXPECT_EQ(list_.count(Severity::Warning), 2) << list_.text();
    EXPECT_EQ(list_.count(Severity::Error), 0) << list_.text();
    EXPECT_NE(list_.text().find("no display type \"sgi\" (known are file, openexr, png, tiff, "
                                "hdr, zfile, shadow)"),
              std::string::npos);
    EXPECT_EQ(readExr("a.sgi.exr").channels.size(), 3u);
    EXPECT_EQ(readExr("window.exr").channels.size(), 4u);
    EXPECT_EQ(readExr("b.exr").channels.size(), 1u);
}

TEST_F(DisplaysTest, OneFileIsWrittenByOneDisplay) {
    display("a.exr", "file", "rgb");
    display("sub/../a.exr", "openexr", "z");
    fill();
    EXPECT_EQ(writeAll().size(), 1u);
    EXPECT_EQ(list_.count(Severity::Error), 0);
    EXPECT_EQ(list_.count(Severity::Warning), 1);
    EXPECT_NE(list_.text().find("writes the same file"), std::string::npos) << list_.text();
    EXPECT_EQ(readExr("a.exr").channels.size(), 3u);
}

// What cannot be written is known before there is a film, and the attempt leaves nothing behind.
TEST_F(DisplaysTest, PlansNeedNoFilm) {
    std::string problem;
    ASSERT_TRUE(writeWholeFile(folder_ + "/file", "x", problem)) << problem;
    fs::create_directory(folder_ + "/folder.exr");
    for (const char *name : {"file/below.exr", "../", "folder.exr"})
        display(name, "openexr", "rgb");
    display("mode.exr", "openexr", "nonsense");
    display("good.exr", "openexr", "rgb");
    ASSERT_EQ(plan().size(), 1u) << list_.text();
    EXPECT_EQ(plan().front().path, folder_ + "/good.exr");
    EXPECT_EQ(list_.count(Severity::Error), 8);
    EXPECT_NE(list_.text().find("cannot make its folder " + folder_ + "/file:"), std::string::npos)
        << list_.text();
    EXPECT_EQ(fileCount(), 2);
}

TEST_F(DisplaysTest, FloatPngIsWarnedAbout) {
    display("a.png", "png", "rgb");
    options_.colorQuantize = QuantizeRecord{0, 0, 0, 0};
    fill();
    EXPECT_EQ(writeAll().size(), 1u);
    EXPECT_EQ(list_.count(Severity::Warning), 1);
}

TEST_F(DisplaysTest, PathsStayInTheOutputFolder) {
    fs::create_directory_symlink(fs::temp_directory_path(), fs::path(folder_) / "link");
    display("../escaped.exr", "openexr", "rgb");
    display("/home/somebody/a.exr", "openexr", "rgb");
    display("link/b.exr", "openexr", "rgb");
    display("C:\\renders\\c.exr", "openexr", "rgb");
    display("sub/folder/inside.exr", "openexr", "rgb");
    display(folder_ + "/absolute.exr", "openexr", "rgb");
    fill();
    EXPECT_EQ(writeAll().size(), 6u) << list_.text();
    EXPECT_EQ(list_.count(Severity::Error), 0);
    EXPECT_EQ(list_.count(Severity::Warning), 4);
    EXPECT_NE(list_.text().find("--trust"), std::string::npos);
    for (const char *name : {"escaped.exr", "a.exr", "b.exr", "c.exr", "sub/folder/inside.exr"})
        EXPECT_TRUE(fs::exists(fs::path(folder_) / name)) << name;

    policy_.folder.directory = folder_ + "/sub";
    policy_.folder.isTrusted = true;
    options_.displays.resize(1);
    EXPECT_EQ(writeAll().size(), 1u);
    EXPECT_TRUE(fs::exists(fs::path(folder_) / "escaped.exr"));
}

TEST_F(DisplaysTest, UnwritablePathsAreErrors) {
    std::string problem;
    ASSERT_TRUE(writeWholeFile(folder_ + "/file", "x", problem)) << problem;
    display("file/below.exr", "openexr", "rgb");
    display("file/below/deep.png", "png", "rgb");
    display("", "openexr", "rgb");
    display("", "tiff", "rgb");
    fill();
    EXPECT_EQ(writeAll().size(), 0u);
    EXPECT_EQ(list_.count(Severity::Error), 4);
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(DisplaysTest, FullDiskLeavesTheOldFileAndNothingElse) {
    std::string problem;
    ASSERT_TRUE(writeWholeFile(folder_ + "/a.exr", "v/1\x01 old", problem));
    display("a.exr", "openexr", "rgb");
    display("b.png", "png", "rgb");
    fill();
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit small = before;
    small.rlim_cur = 64;
    std::signal(SIGXFSZ, SIG_IGN); // As the program does.
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::size_t written = writeAll().size();
    setrlimit(RLIMIT_FSIZE, &before);
    EXPECT_EQ(written, 0u);
    EXPECT_EQ(list_.count(Severity::Error), 2);
    EXPECT_NE(list_.text().find("File too large"), std::string::npos) << list_.text();
    EXPECT_EQ(readWholeFile(folder_ + "/a.exr", problem), "v/1\x01 old");
    EXPECT_EQ(fileCount(), 1);
}

TEST_F(DisplaysTest, SpecialFilesAreNotReplaced) {
    std::string problem;
    EXPECT_FALSE(writeWholeFile("/dev/null", "x", problem));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    ASSERT_TRUE(writeWholeFile(folder_ + "/real", "x", problem));
    fs::create_symlink(folder_ + "/real", folder_ + "/alias");
    EXPECT_TRUE(writeWholeFile(folder_ + "/alias", "new", problem));
    EXPECT_TRUE(fs::is_symlink(folder_ + "/alias"));
    EXPECT_EQ(readWholeFile(folder_ + "/real", problem), "new");
}

TEST(Imaging, Exposure) {
    EXPECT_EQ(exposed(0.25f, {2, 1}), 0.5f);
    EXPECT_FLOAT_EQ(exposed(0.25f, {1, 2}), 0.5f);
    EXPECT_FLOAT_EQ(exposed(0.125f, {8, 2.2f}), 1);
    EXPECT_EQ(exposed(-0.25f, {2, 1}), -0.5f);
    EXPECT_FLOAT_EQ(exposed(-0.25f, {1, 2}), -0.5f);
}

/// IEC 61966-2-1: a line below 0.0031308, 1.055 l^(1/2.4) - 0.055 above.
TEST(Imaging, SrgbCurve) {
    const float table[][2] = {{0, 0},           {.001f, .01292f}, {.0031308f, .04045f},
                              {.18f, .46136f},  {.5f, .735357f},  {1, 1},
                              {-.5f, -.735357f}};
    for (const auto &[light, value] : table)
        EXPECT_NEAR(srgbCurve(light), value, 1e-5f) << light;
    for (const float light : {-1.5f, 0.f, .001f, .0031308f, .01f, .18f, 1.f, 3.f})
        EXPECT_NEAR(linearOfSrgb(srgbCurve(light)), light, 1e-6f * std::max(1.f, std::abs(light)));
}

TEST(Imaging, QuantiseTable) {
    const QuantizeRecord plain{255, 0, 255, 0};
    EXPECT_EQ(quantized(0, plain, 0), 0);
    EXPECT_EQ(quantized(1, plain, 0), 255);
    EXPECT_EQ(quantized(0.5f, plain, 0), 128);
    EXPECT_EQ(quantized(2, plain, 0), 255);
    EXPECT_EQ(quantized(-1, plain, 0), 0);
    EXPECT_EQ(quantized(0.7f, {0, 0, 0, 0.5f}, 1), 0.7f);
    EXPECT_EQ(quantized(10 / 255.0f, eightBitQuantize, 0.9f), 10);
    EXPECT_EQ(quantized(10.4f / 255, eightBitQuantize, 0.5f), 11);
}

TEST(Imaging, DitherKeepsTheMean) {
    for (double level : {10.0, 10.2, 10.5, 10.9}) {
        double sum = 0;
        constexpr int n = 300;
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) {
                const float noise = ditherNoise(x, y, 1);
                ASSERT_TRUE(noise >= -1 && noise < 1);
                sum += quantized(float(level / 255), eightBitQuantize, noise);
            }
        EXPECT_NEAR(sum / (n * n), level, 5 * 0.5 / n); // Five standard deviations at most.
    }
}

} // namespace
} // namespace candela
