// SPDX-License-Identifier: Apache-2.0
#include "render/solution_keeping.h"

#include "foundation/base/sealed_bytes.h"
#include "foundation/base/whole_file.h"
#include "light/radiosity/solution_mesh.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>

namespace candela {

namespace {

using radiosity::Solution;
using radiosity::SolutionData;

constexpr std::string_view mark = "candela solution 2\n";

/// Nothing, and `problem`, if the file holds none of this scene.
std::optional<SolutionData> readSolution(const std::string &file, const FrameIdentity &identity,
                                         std::string &problem) {
    const auto bytes = readWholeFile(file, problem);
    if (!bytes)
        return std::nullopt;
    auto body = unsealed(mark, "solution", *bytes, problem);
    if (!body)
        return std::nullopt;
    FrameIdentity saved;
    std::optional<SolutionData> data;
    if (takeIdentity(*body, saved)) {
        problem = differenceOf(saved, identity);
        if (!problem.empty())
            return std::nullopt;
        data = radiosity::solutionOf(*body);
    }
    if (!data)
        problem = "it is damaged";
    return data;
}

void writeSolution(const Solution &solution, const std::string &file, const FrameIdentity &identity,
                   DiagnosticSink &diagnostics) {
    std::string body, problem;
    appendIdentity(body, identity);
    body += radiosity::bytesOf(solution.data());
    if (!writeWholeFile(file, sealed(mark, std::move(body)), problem))
        diagnostics.error({}, "the solution is not kept: " + problem);
}

void writeMesh(const Solution &solution, const Scene &scene, const std::string &file,
               DiagnosticSink &diagnostics) {
    const Matrix4 worldFromCurrent =
        inverse(scene.options().camera.cameraFromWorld).value_or(Matrix4{});
    std::string problem;
    if (!writeWholeFile(file, radiosity::plyOf(solution, worldFromCurrent), problem))
        diagnostics.error({}, "there is no mesh of the solution: " + problem);
}

/// What can be known before the scene is solved.
bool canWrite(const RenderSettings &settings, DiagnosticSink &diagnostics) {
    for (const std::string &file : {settings.solutionFile, settings.solutionMesh})
        if (std::string problem; !file.empty() && !canWriteFile(file, problem)) {
            diagnostics.error({}, problem);
            return false;
        }
    return true;
}

} // namespace

FrameIdentity solutionIdentity(const Scene &scene, const RenderSettings &settings,
                               const std::string &world, const std::string &shaders) {
    const Matrix4d &camera = scene.options().camera.exactCameraFromWorld;
    return {{"version", CANDELA_VERSION},
            {"scale", fmt::format("{:.4g}", std::cbrt(std::fabs(determinant3(camera))))},
            {"seed", std::to_string(settings.seed)},
            {"scene", world},
            {"shaders", shaders}};
}

bool keepSolution(const Scene &scene, const RenderSettings &settings, const FrameIdentity &identity,
                  IntegratorSettings &integrator, DiagnosticSink &diagnostics) {
    const std::string file = settings.solutionFile, mesh = settings.solutionMesh;
    if (file.empty() && mesh.empty())
        return true;
    if (integrator.kind != IntegratorKind::Radiosity) {
        diagnostics.warning({}, "only --integrator radiosity has a solution; none is kept");
        return true;
    }
    if (!canWrite(settings, diagnostics))
        return false;
    const bool isThere = !file.empty() && std::filesystem::exists(file);
    if (isThere) {
        std::string problem;
        auto data = readSolution(file, identity, problem);
        if (!data) {
            diagnostics.error({}, "the solution in " + file + " is not of this scene: " + problem +
                                      "; name another file to have it solved");
            return false;
        }
        integrator.solved = std::make_shared<const SolutionData>(std::move(*data));
    }
    integrator.whenSolved = [=, &scene, &diagnostics](const Solution &solution) {
        if (!file.empty() && !isThere)
            writeSolution(solution, file, identity, diagnostics);
        if (!mesh.empty())
            writeMesh(solution, scene, mesh, diagnostics);
    };
    return true;
}

} // namespace candela
