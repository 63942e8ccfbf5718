// SPDX-License-Identifier: Apache-2.0
// Bounds of shaders against what the shaders do: no point of a box may lie outside of its bound,
// nearly all boxes must have one, and it must not be much wider than need be.
//
//     bounds_trial [--random COUNT] [--first SEED] [--boxes COUNT] [--grid N] [--table] [--limits]
//                  [FOLDER...]
//
// tries all surface shaders of the folders, and so many random ones, on a square, a cylinder and a
// sphere. Exit status 1 if anything is wrong; with --limits also if fewer than 90 % of the folders'
// shaders have bounds on all boxes of a 64 x 64 grid of the square, or if one's tolerances there
// are more than 3 times its deviations in the median or 10 times at the 90th percentile.
#include "patches.h"
#include "random_shader.h"

#include "language/semantics/front.h"
#include "world/shading/shader_bounds.h"
#include "world/shading/shader_library.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace candela::bounds {
namespace {

constexpr int samples = 64;
constexpr double notable = 1e-3; ///< Deviations from here on tell how tight a bound is.

struct Settings {
    int random = 0, boxes = 48;
    unsigned first = 1;
    int grid = 0; ///< Only boxes of this one; 0: of all.
    bool table = false, limits = false;
    std::vector<std::string> folders;
};

struct Result {
    long points = 0, violations = 0, boxes = 0, finite = 0;
    std::vector<double> flat, round; ///< Tolerance over deviation, on the square and elsewhere.
    std::string firstViolation;
};

double quantile(std::vector<double> &ratios, double share) {
    if (ratios.empty())
        return 0;
    const auto at = std::size_t(share * double(ratios.size() - 1));
    std::nth_element(ratios.begin(), ratios.begin() + std::ptrdiff_t(at), ratios.end());
    return ratios[at];
}

class ShaderTrial {
public:
    ShaderTrial(const ShaderInstance &instance, unsigned seed)
        : boxes_(instance, 1), points_(instance, samples), bits_(seed) {}

    /// Boxes of a grid of so many by so many.
    void tryBoxes(Patch patch, int count, int grid, Result &result) {
        for (int n = 0; n < count; ++n) {
            const double side = 1.0 / grid;
            const auto cell = [&] { return (double(bits_() % unsigned(grid)) + .5) * side; };
            const double u = cell(), v = cell();
            tryBox(patch, {u, v, side, side}, result);
        }
    }

private:
    void tryBox(Patch patch, const Box &box, Result &result) {
        put(boxes_, 0, patch, box);
        boxes_.ask(1);
        const Vector field = placeAt(patch, box.u, box.v).N;
        std::uniform_real_distribution<double> share(-.5, .5);
        double du[samples], dv[samples];
        for (int i = 0; i < samples; ++i) {
            du[i] = (i < 4 ? (i & 1) - .5 : share(bits_)) * box.Du;
            dv[i] = (i < 4 ? (i >> 1) - .5 : share(bits_)) * box.Dv;
            put(points_, i, patch, box.u + du[i], box.v + dv[i], field);
        }
        points_.askValues(samples);
        bool isFinite = true;
        const BoundPlanes bounds[] = {boxes_.reflectance(), boxes_.emission(), boxes_.opacity()};
        const BoundPlanes values[] = {points_.reflectance(), points_.emission(), points_.opacity()};
        for (std::size_t q = 0; q < 3; ++q)
            for (std::size_t c = 0; c < std::size_t(colorSamples); ++c) {
                const double tolerance = double(bounds[q].tolerance[c][0]);
                isFinite &= tolerance < 1e30;
                double most = 0;
                for (int i = 0; i < samples; ++i) {
                    const double off = std::abs(
                        double(values[q].value[c][i]) - double(bounds[q].value[c][0]) -
                        double(bounds[q].byU[c][0]) * du[i] - double(bounds[q].byV[c][0]) * dv[i]);
                    most = std::max(most, off);
                    ++result.points;
                    if (!(off <= tolerance) && !(tolerance > 3e38))
                        tell(patch, box, q, c, off, tolerance, result);
                }
                if (most > notable && tolerance < 1e30 && box.Du < .2)
                    (patch == Patch::Square ? result.flat : result.round)
                        .push_back(tolerance / most);
            }
        if (box.Du == 1.0 / 64 && patch == Patch::Square) {
            ++result.boxes;
            result.finite += isFinite;
        }
    }

    static void tell(Patch patch, const Box &box, std::size_t quantity, std::size_t channel,
                     double off, double tolerance, Result &result) {
        if (result.violations++ > 0)
            return;
        const char *const names[] = {"reflectance", "emission", "opacity"};
        std::ostringstream text;
        text << names[quantity] << "." << channel << " on the " << nameOf(patch) << ", box at ("
             << box.u << ", " << box.v << ") of " << box.Du << ": " << off << " off, " << tolerance
             << " allowed";
        result.firstViolation = text.str();
    }

    BoxBounds boxes_, points_;
    std::mt19937 bits_;
};

class Trial {
public:
    explicit Trial(const Settings &settings) : settings_(settings) {}

    int status() {
        for (const std::string &folder : settings_.folders) {
            std::vector<std::filesystem::path> files;
            for (const auto &entry : std::filesystem::directory_iterator(folder))
                if (entry.path().extension() == ".sl")
                    files.push_back(entry.path());
            std::ranges::sort(files);
            for (const auto &file : files)
                if (isSurface(file))
                    tryShader(folder, file.stem().string(), true);
        }
        const auto scratch = std::filesystem::temp_directory_path() /
                             ("candela-bounds-" + std::to_string(std::random_device{}()));
        std::filesystem::create_directories(scratch);
        for (int n = 0; n < settings_.random; ++n) {
            const std::string name = "random" + std::to_string(settings_.first + unsigned(n));
            std::ofstream(scratch / (name + ".sl"))
                << randomShader(settings_.first + unsigned(n), name);
            const bool isRight = tryShader(scratch.string(), name, false);
            if (!isRight)
                std::printf("%s\n", randomShader(settings_.first + unsigned(n), name).c_str());
        }
        std::filesystem::remove_all(scratch);
        std::printf(
            "%ld points of %d shaders, %ld outside; %d of %d shaders of the folders have bounds "
            "on all boxes of a flat 64 x 64 grid\ntolerance over deviation, where that is above "
            "%g: "
            "flat %.2f in the median, %.2f at 90 %%; round %.2f, %.2f\n",
            points_, shaders_, violations_, covered_, named_, notable, quantile(all_.flat, .5),
            quantile(all_.flat, .9), quantile(all_.round, .5), quantile(all_.round, .9));
        const bool isLimited = isLoose_ || covered_ * 10 < named_ * 9;
        return violations_ || failed_ || (settings_.limits && isLimited) ? 1 : 0;
    }

private:
    static bool isSurface(const std::filesystem::path &file) {
        std::ifstream in(file);
        std::ostringstream text;
        text << in.rdbuf();
        DiagnosticList diagnostics;
        const auto front = sl::analyzeSource(
            {file.string(), text.str()}, {{file.parent_path().string()}, {}, false}, diagnostics);
        return front && front->shaders.size() == 1 &&
               front->shaders[0]->kind == sl::ShaderKind::Surface;
    }

    bool tryShader(const std::string &folder, const std::string &name, bool isNamed) {
        DiagnosticList diagnostics;
        ShaderLibrarySettings settings;
        settings.folders = {folder};
        settings.libraryFolders = {std::string(CANDELA_SOURCE_DIR) + "/shaders/surface"};
        ShaderLibrary library(settings, diagnostics);
        ShaderRecord record;
        record.name = name;
        const auto instance =
            library.instance(ShaderKind::Surface, record, Options(), ir::LightRule::Path, {});
        // A faulty shader becomes another; the library's default surface is one by rights.
        if (!instance || (instance->code->name() != name && name != "defaultsurface")) {
            std::printf("%s: %s\n", name.c_str(), diagnostics.text().c_str());
            failed_ = true;
            return false;
        }
        instance->code->bindSpaces({}, diagnostics);
        ShaderTrial trial(*instance, 7);
        Result result;
        for (Patch patch : patches)
            for (int grid : {64, 16, 4, 1024, 1})
                if (settings_.grid == 0 || settings_.grid == grid)
                    trial.tryBoxes(patch, grid == 64 ? settings_.boxes : settings_.boxes / 4, grid,
                                   result);
        return take(name, isNamed, result);
    }

    bool take(const std::string &name, bool isNamed, Result &result) {
        ++shaders_;
        points_ += result.points, violations_ += result.violations;
        const double share = double(result.finite) / double(std::max(1l, result.boxes));
        named_ += isNamed, covered_ += isNamed && share == 1;
        const double median = quantile(result.flat, .5), most = quantile(result.flat, .9);
        // Quantiles of a few boxes, around a single jump, tell nothing of a shader.
        constexpr std::size_t enough = 10;
        isLoose_ |= isNamed && result.flat.size() >= enough && (median > 3 || most > 10);
        all_.flat.insert(all_.flat.end(), result.flat.begin(), result.flat.end());
        all_.round.insert(all_.round.end(), result.round.begin(), result.round.end());
        if (settings_.table)
            std::printf("%-18s %8ld points %5.1f %% bounded; flat %6zu: %6.2f %8.2f; round %6zu: "
                        "%6.2f %8.2f\n",
                        name.c_str(), result.points, 100 * share, result.flat.size(),
                        quantile(result.flat, .5), quantile(result.flat, .9), result.round.size(),
                        quantile(result.round, .5), quantile(result.round, .9));
        if (result.violations)
            std::printf("%s: %ld outside: %s\n", name.c_str(), result.violations,
                        result.firstViolation.c_str());
        return result.violations == 0;
    }

    Settings settings_;
    long points_ = 0, violations_ = 0;
    int shaders_ = 0, covered_ = 0, named_ = 0;
    Result all_;
    bool failed_ = false, isLoose_ = false;
};

} // namespace
} // namespace candela::bounds

int main(int count, char **words) {
    candela::bounds::Settings settings;
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        const auto value = [&] { return k + 1 < count ? std::atoi(words[++k]) : 0; };
        if (word == "--random")
            settings.random = value();
        else if (word == "--first")
            settings.first = unsigned(value());
        else if (word == "--boxes")
            settings.boxes = value();
        else if (word == "--grid")
            settings.grid = value();
        else if (word == "--limits")
            settings.limits = true;
        else if (word == "--table")
            settings.table = true;
        else
            settings.folders.push_back(word);
    }
    return candela::bounds::Trial(settings).status();
}
