// SPDX-License-Identifier: Apache-2.0
// Lookups of textures on one thread: a compiled shader that asks the renderer, against OpenImageIO
// called by hand in its batches of sixteen with the same coordinates and extents. Prints JSON:
// lookups a microsecond, a number a round.
#include "interface/ri/options.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"
#include "language/ir/transform/light_rule.h"
#include "language/jit/jit.h"
#include "language/semantics/front.h"
#include "world/texture/module.h"
#include "world/texture/textures.h"

#include <OpenImageIO/texture.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <unistd.h>

namespace candela::bench {
namespace {

constexpr int points = 1024, width = 16;
constexpr double secondsARound = 0.02;

double threadSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// What the points are: neighbours on a surface, each with a footprint of so many texels.
struct Case {
    const char *name;
    float texelsAcross, texelsAlong; ///< Below 1: seen large.
};
constexpr Case cases[] = {{"fine", 1.5f, 1.5f}, {"slanting", 1.5f, 9}, {"large", 0.2f, 0.2f}};

std::string writeTexture(const std::string &folder, std::string &problem) {
    PictureData picture;
    PictureFacts &facts = picture.facts;
    facts.width = facts.height = facts.frameWidth = facts.frameHeight = 1024, facts.channels = 3;
    for (int i = 0; i < 1024 * 1024 * 3; ++i)
        picture.values.push_back(float((i * 2654435761u) >> 24) / 255);
    const std::string path = folder + "/noise.tx";
    PictureLibrary *library = pictureLibrary(problem);
    const bool good =
        library && library->write(picture, {"periodic", "periodic", "box"}, path, problem);
    return good ? path : "";
}

/// The inputs that the shader's coordinates follow from: s and t are (u,v).
void placePoints(const Case &which, ir::TestBatch &batch) {
    const float across = which.texelsAcross / 1024, along = which.texelsAlong / 1024;
    for (int i = 0; i < batch.padded(); ++i) {
        const auto set = [&](ShaderInput input, float value) {
            batch.inputs[std::size_t(input)][std::size_t(i)] = value;
        };
        set(ShaderInput::s, 0.2f + across * float(i % 32)), set(ShaderInput::dsdu, 1);
        set(ShaderInput::t, 0.3f + along * float(i / 32)), set(ShaderInput::dtdv, 1);
        set(ShaderInput::dsdv, 0), set(ShaderInput::dtdu, 0);
        set(ShaderInput::dudx, across), set(ShaderInput::dvdx, 0);
        set(ShaderInput::dudy, 0), set(ShaderInput::dvdy, along);
        set(ShaderInput::uShift, 0), set(ShaderInput::vShift, 0);
    }
}

std::optional<ir::Function> shader(const std::string &texture, DiagnosticSink &diagnostics) {
    const std::string source =
        "surface lookup() { Oi = 1; Ci = color texture(\"" + texture + "\", s, t); }";
    const auto front = sl::analyzeSource({"lookup.sl", source}, {}, diagnostics);
    const auto lowered = front ? ir::lower(*front->shaders[0], {}, {}, diagnostics) : std::nullopt;
    if (!lowered)
        return std::nullopt;
    return ir::slice(ir::applyLightRule(ir::fold(lowered->whole, {}), ir::LightRule::Classic),
                     ir::Question::Shade);
}

class ByHand {
public:
    explicit ByHand(const std::string &texture)
        : system_(OIIO::TextureSystem::create(false)),
          handle_(system_->get_texture_handle(OIIO::ustring(texture))) {}

    void look(const ShaderArgs &args, float *result) {
        using namespace OIIO::Tex;
        OIIO::TextureOptBatch options;
        options.swrap = options.twrap = decltype(options.swrap)(Wrap::Periodic);
        options.anisotropic = 64;
        OIIO::TextureSystem::Perthread *thread = system_->get_perthread_info();
        const auto in = [&](ShaderInput input, int first) {
            return args.inputs[int(input)] + first;
        };
        for (int first = 0; first < points; first += width)
            system_->texture(handle_, thread, options, RunMaskOn, in(ShaderInput::s, first),
                             in(ShaderInput::t, first), in(ShaderInput::dudx, first),
                             in(ShaderInput::dvdx, first), in(ShaderInput::dudy, first),
                             in(ShaderInput::dvdy, first), 3, result + 3 * first);
    }

private:
    static constexpr OIIO::Tex::RunMask RunMaskOn = 0xffff;
    OIIO::TextureSystem *system_;
    OIIO::TextureSystem::TextureHandle *handle_;
};

/// Lookups a microsecond.
double rateOf(const std::function<void()> &once) {
    int calls = 0;
    const double start = threadSeconds();
    double taken = 0;
    for (; taken < secondsARound; taken = threadSeconds() - start, ++calls)
        once();
    return 1e-6 * points * calls / taken;
}

void print(const char *name, const std::vector<double> &rates) {
    std::printf("\"%s\": [", name);
    for (std::size_t k = 0; k < rates.size(); ++k)
        std::printf("%s%.4g", k ? ", " : "", rates[k]);
    std::printf("]");
}

bool measure(const std::string &texture, int rounds) {
    DiagnosticList diagnostics;
    const auto function = shader(texture, diagnostics);
    Jit jit({}, diagnostics);
    const ShaderFunction code = function ? jit.compile(*function) : nullptr;
    Textures textures({}, diagnostics);
    textures.bind(Options{});
    ByHand byHand(texture);
    for (const Case &which : cases) {
        ir::TestBatch batch(*function, points, 1);
        placePoints(which, batch);
        batch.services.context = &textures;
        batch.services[Service::texture] = [](void *context, const ServiceCall &call) {
            static_cast<Textures *>(context)->texture(call);
        };
        std::vector<float> result(3 * points);
        std::vector<double> compiled, bare;
        float difference = 0;
        batch.run(*function, [&](const ir::Function &, const ShaderArgs &args) {
            for (int round = 0; code && round < rounds; ++round) {
                compiled.push_back(rateOf([&] { code(&args); }));
                bare.push_back(rateOf([&] { byHand.look(args, result.data()); }));
            }
            for (int i = 0; i < points; ++i) // By hand, planes of a batch lie side by side.
                difference = std::max(
                    difference, std::abs(args.outputs[0][i] -
                                         result[std::size_t(i / width * 3 * width + i % width)]));
        });
        // Candela makes footprints somewhat shorter (docs/textures.md), which shows unless they are
        // smaller than a texel.
        if (!code || (which.texelsAlong < 1 && difference > 1e-3f)) {
            std::fprintf(stderr, "%s: by hand it is something else (%g)\n%s", which.name,
                         double(difference), diagnostics.text().c_str());
            return false;
        }
        std::printf("%s\n  \"%s\": {", &which == cases ? "" : ",", which.name);
        print("compiled", compiled), std::printf(", "), print("byHand", bare);
        std::printf("}");
    }
    return true;
}

} // namespace
} // namespace candela::bench

int main(int count, char **words) {
    using namespace candela::bench;
    const int rounds = count > 1 ? std::atoi(words[1]) : 9;
    if (rounds < 1) {
        std::fprintf(stderr, "texture_bench [ROUNDS]\n");
        return 2;
    }
    std::string folder = std::filesystem::temp_directory_path().string() + "/texture_bench.XXXXXX";
    if (!mkdtemp(folder.data()))
        return 1;
    std::string problem;
    const std::string texture = writeTexture(folder, problem);
    if (texture.empty())
        std::fprintf(stderr, "%s\n", problem.c_str());
    std::printf("{\"lookups\": {");
    const bool good = !texture.empty() && measure(texture, rounds);
    std::printf("}}\n");
    std::filesystem::remove_all(folder);
    return good ? 0 : 1;
}
