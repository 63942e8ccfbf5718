// SPDX-License-Identifier: Apache-2.0
#include "render/statistics.h"

#include "foundation/base/instruction_set.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <sys/resource.h>

namespace candela {

namespace {

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Of all threads of the process.
double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

} // namespace

Statistics::Statistics() : wallAtStart_(wallSeconds()) {}

void Statistics::measure(const std::string &name, const std::function<void()> &work) {
    double wall = wallSeconds(), cpu = cpuSeconds();
    // The first sample is near once the first such work begins.
    numbers_.try_emplace(name + ".startSeconds", wall - wallAtStart_);
    work();
    numbers_[name + ".wallSeconds"] += wallSeconds() - wall;
    numbers_[name + ".cpuSeconds"] += cpuSeconds() - cpu;
}

void Statistics::add(const Scene &scene, const TransportStatistics &transport) {
    Scene::Statistics s = scene.statistics();
    numbers_["scene.primitives"] += double(s.primitives);
    numbers_["scene.triangles"] += double(s.triangles);
    numbers_["scene.lights"] += double(s.lights);
    numbers_["scene.shaderCodes"] += double(s.codes);
    numbers_["scene.dicingSeconds"] += s.secondsDicing;
    numbers_["scene.buildingSeconds"] += s.secondsBuilding;
    numbers_["transport.raySeconds"] += s.secondsTracing;
    numbers_["transport.paths"] += double(transport.paths);
    numbers_["transport.lightPaths"] += double(transport.lightPaths);
    numbers_["transport.cameraRays"] += double(transport.cameraRays);
    numbers_["transport.bounceRays"] += double(transport.bounceRays);
    numbers_["transport.shadowRays"] += double(transport.shadowRays);
    numbers_["transport.nonFiniteSamples"] += double(transport.nonFiniteSamples);
    const radiosity::SolverStatistics &solver = transport.solver;
    if (solver.elements == 0)
        return;
    numbers_["radiosity.elements"] += double(solver.elements);
    numbers_["radiosity.links"] += double(solver.links);
    numbers_["radiosity.clusterLinks"] += double(solver.clusterLinks);
    numbers_["radiosity.lampLinks"] += double(solver.lampLinks);
    numbers_["radiosity.iterations"] += solver.iterations;
    numbers_["radiosity.seconds"] += solver.seconds;
    numbers_["radiosity.directFlux"] += solver.directFlux;
    numbers_["radiosity.indirectFlux"] += solver.indirectFlux;
}

void Statistics::add(const Jit::Statistics &jit) {
    numbers_["jit.compiled"] += jit.compiled;
    numbers_["jit.fromCache"] += jit.fromCache;
    numbers_["jit.optimisingSeconds"] += jit.secondsOptimising;
    numbers_["jit.emittingSeconds"] += jit.secondsEmitting;
}

void Statistics::write(const std::string &path, DiagnosticSink &diagnostics) const {
    std::map<std::string, double> all = numbers_;
    all["process.cpuSeconds"] = cpuSeconds();
    all["process.wallSeconds"] = wallSeconds() - wallAtStart_;
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    all["process.peakMegabytes"] = double(usage.ru_maxrss) / 1024;

    all["process.instructionSet"] = 2 + int(instructionSet()); // x86-64-v2, v3, v4

    std::FILE *file = std::fopen(path.c_str(), "w");
    bool good = file != nullptr;
    if (file) {
        const char *separator = "{\n";
        for (const auto &[name, value] : all) {
            good &= std::fprintf(file, "%s  \"%s\": %.9g", separator, name.c_str(), value) > 0;
            separator = ",\n";
        }
        good &= std::fputs("\n}\n", file) >= 0;
        good &= std::fclose(file) == 0;
    }
    if (!good)
        diagnostics.error({}, "cannot write the statistics to " + path);
}

} // namespace candela
