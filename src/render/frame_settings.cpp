// SPDX-License-Identifier: Apache-2.0
#include "render/frame_settings.h"

#include "foundation/base/instruction_set.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace candela {

namespace {

/// Options "bidir" and "vcm": how many paths begin on lights, and what becomes of them.
BidirectionalWishes wishesOf(const NamedParameters &named) {
    BidirectionalWishes wishes;
    if (const double paths = named.number("bidir:lightpaths", -1); paths >= 0)
        wishes.lightPaths = paths;
    if (const double connections = named.number("bidir:connections", -1); connections >= 0)
        wishes.connections = int(connections);
    wishes.trust = named.number("bidir:trust", 1);
    wishes.merges = named.string("render:integrator", "") == "vcm";
    if (const double radius = named.number("vcm:radius", 0); radius > 0)
        wishes.radius = float(radius);
    wishes.trustInMerging = named.number("vcm:trust", 1);
    return wishes;
}

FinalPass finalPassOf(const NamedParameters &named) {
    const std::string name = named.string("radiosity:finalpass", "fe");
    return name == "gather"      ? FinalPass::Gather
           : name == "fe+direct" ? FinalPass::Direct
                                 : FinalPass::Elements;
}

radiosity::SolverSettings solverSettings(const NamedParameters &named, std::uint32_t seed) {
    radiosity::SolverSettings solver;
    solver.seed = seed;
    solver.order = int(named.number("radiosity:order", solver.order));
    solver.epsilon = named.number("radiosity:epsilon", solver.epsilon);
    solver.contrast = named.number("radiosity:contrast", solver.contrast);
    solver.leastElement = named.number("radiosity:leastelement", solver.leastElement);
    solver.directSamples = int(named.number("radiosity:samples", solver.directSamples));
    return solver;
}

/// Option "trace" "maxdepth": how often light may be scattered.
int maxDepthOf(const Options &options) {
    constexpr int usual = 64;
    return int(options.named.number("trace:maxdepth", usual));
}

/// PixelVariance is said of pixels as displays show them, before gamma: here, of radiance.
double varianceOf(const Options &options) {
    const double gain = options.exposure.value_or(ExposureRecord{}).gain;
    const double variance = options.pixelVariance.value_or(0);
    return variance > 0 ? variance / (gain * gain) : 0;
}

} // namespace

IntegratorSettings integratorSettings(const Scene &scene, const RenderSettings &settings) {
    const Options &options = scene.options();
    IntegratorSettings result;
    result.kind = scene.isClassic()         ? IntegratorKind::Classic
                  : scene.isBidirectional() ? IntegratorKind::Bidirectional
                  : scene.isSolved()        ? IntegratorKind::Radiosity
                                            : IntegratorKind::Path;
    result.finalPass = finalPassOf(options.named);
    result.solver = solverSettings(options.named, settings.seed);
    const double samples =
        std::round(double(std::max(1.0f, options.xSamples)) * std::max(1.0f, options.ySamples));
    result.lastSample = int(std::min<double>(samples, maximumSamplesPerPixel));
    if (result.kind != IntegratorKind::Bidirectional)
        result.variance = varianceOf(options);
    result.seed = settings.seed;
    result.maxDepth = maxDepthOf(options);
    result.hemisphereOnly = settings.hemisphereOnly;
    result.bidirectional = wishesOf(options.named);
    result.crop = options.format.cropPixels();
    return result;
}

const char *integratorName(const IntegratorSettings &settings) {
    switch (settings.kind) {
    case IntegratorKind::Classic: return "classic";
    case IntegratorKind::Path: return "path";
    case IntegratorKind::Radiosity: return "radiosity";
    case IntegratorKind::Bidirectional: break;
    }
    return settings.bidirectional.merges ? "vcm" : "bidir";
}

FrameDescription describeFrame(const Scene &scene, const IntegratorSettings &integrator,
                               const std::string &file) {
    FrameDescription description;
    description.metadata = {{"renderer", "Candela"},
                            {"scene", std::filesystem::path(file).filename().string()},
                            {"integrator", integratorName(integrator)},
                            {"spp", std::to_string(integrator.lastSample)},
                            {"seed", std::to_string(integrator.seed)},
                            {"maxdepth", std::to_string(integrator.maxDepth)},
                            {"sampling", integrator.hemisphereOnly ? "hemisphere" : "cones"}};
    const Matrix4 &worldToCamera = scene.options().camera.cameraFromWorld;
    description.worldToCamera = worldToCamera;
    description.worldToNdc = worldToCamera * scene.camera().ndcFromCamera();
    return description;
}

FrameIdentity identityOf(const Scene &scene, const RenderSettings &settings,
                         const std::string &requests, const std::string &shaders) {
    const IntegratorSettings integrator = integratorSettings(scene, settings);
    const auto [width, height] = scene.options().format.effectiveResolution();
    return {{"version", CANDELA_VERSION},
            {"instruction set", nameOf(instructionSet())},
            {"lanes", std::to_string(settings.jit.width)},
            {"seed", std::to_string(settings.seed)},
            {"samples a pixel", std::to_string(integrator.lastSample)},
            {"pixel variance", fmt::format("{}", integrator.variance)},
            {"integrator", integratorName(integrator)},
            {"sampling", settings.hemisphereOnly ? "hemisphere" : "cones"},
            {"resolution", fmt::format("{} x {}", width, height)},
            {"crop", fmt::format("{}", fmt::join(integrator.crop, " "))},
            {"scene", requests},
            {"shaders", shaders}};
}

} // namespace candela
