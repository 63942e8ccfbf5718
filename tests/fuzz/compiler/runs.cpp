// SPDX-License-Identifier: Apache-2.0
#include "runs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

namespace candela::fuzz {

namespace {

using Plane = ir::TestBatch::Plane;

void notePrint(void *context, const ServiceCall &call) {
    RunResult &run = *static_cast<RunResult *>(context);
    for (const std::string &line : ir::printedLines(call)) {
        ++run.lines;
        run.digest += std::hash<std::string>()(line);
    }
}

void noteOutside(void *context, const char *file, std::int32_t line) {
    static_cast<RunResult *>(context)->outside.emplace(file, line);
}

std::vector<Plane> randomPlanes(std::size_t count, int size, Chance &chance) {
    std::vector<Plane> planes(count, Plane(std::size_t(size)));
    for (Plane &plane : planes)
        for (float &x : plane)
            x = float(chance.below(2049)) / 1024;
    return planes;
}

/// Some numbers that computations stumble over, among the ordinary ones.
void addSpecials(std::vector<Plane> &planes, Chance &chance) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float specials[] = {
        0,     -0.0f,  1,   -1, infinity, -infinity, std::numeric_limits<float>::quiet_NaN(),
        1e30f, 1e-40f, 0.5f};
    for (Plane &plane : planes)
        for (float &x : plane)
            if (chance.oneIn(8))
                x = chance.pick(specials);
}

std::string differenceAt(const char *what, std::size_t plane, std::size_t lane, float expected,
                         float found) {
    return std::string(what) + " " + std::to_string(plane) + ", lane " + std::to_string(lane) +
           ": " + std::to_string(expected) + " expected, " + std::to_string(found) + " found";
}

int findOutput(const ir::Function &function, const std::string &name, int component) {
    for (std::size_t k = 0; k < function.outputs.size(); ++k)
        if (function.outputs[k].name == name && function.outputs[k].component == component)
            return int(k);
    return -1;
}

std::vector<const float *> pointersTo(const std::vector<Plane> &planes) {
    std::vector<const float *> pointers;
    for (const Plane &plane : planes)
        pointers.push_back(plane.data());
    return pointers;
}

} // namespace

bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

std::string differenceOf(const RunResult &expected, const RunResult &found) {
    for (std::size_t k = 0; k < expected.outputs.size(); ++k)
        for (std::size_t i = 0; i < expected.outputs[k].size(); ++i)
            if (!sameBits(expected.outputs[k][i], found.outputs[k][i]))
                return differenceAt("output", k, i, expected.outputs[k][i], found.outputs[k][i]);
    for (const auto frame : {&ir::TestFrames::surface, &ir::TestFrames::view}) {
        const Plane &a = expected.frames.*frame, &b = found.frames.*frame;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (!sameBits(a[i], b[i]))
                return differenceAt("frame", frame == &ir::TestFrames::view, i, a[i], b[i]);
    }
    if (expected.lines != found.lines || expected.digest != found.digest)
        return std::to_string(expected.lines) + " lines printed, other than " +
               std::to_string(found.lines);
    return expected.outside == found.outside ? "" : "indices outside are not those reported";
}

std::string differenceOfOutputs(const ir::Function &whole, const RunResult &expected,
                                const std::string &wholeName, const ir::Function &slice,
                                const RunResult &found, const std::string &name) {
    for (int component = 0;; ++component) {
        const int a = findOutput(whole, wholeName, component);
        const int b = findOutput(slice, name, component);
        if (a < 0)
            return component ? "" : "no output " + wholeName;
        if (b < 0)
            return "no output " + name;
        const Plane &x = expected.outputs[std::size_t(a)], &y = found.outputs[std::size_t(b)];
        for (std::size_t i = 0; i < x.size(); ++i)
            if (std::isfinite(x[i]) && !(x[i] == y[i]))
                return differenceAt(name.c_str(), std::size_t(component), i, x[i], y[i]);
    }
}

/// Where no box is asked about, the region that is sampled stands for it.
static void takeSampledRegion(std::vector<ir::TestPlane> &inputs) {
    const auto plane = [&](ShaderInput input) -> ir::TestPlane & {
        return inputs[std::size_t(input)];
    };
    plane(ShaderInput::Du) = plane(ShaderInput::du);
    plane(ShaderInput::Dv) = plane(ShaderInput::dv);
    plane(ShaderInput::Dw).assign(plane(ShaderInput::Dw).size(), 0);
}

Batch::Batch(const ir::LoweredShader &shader, Chance &chance)
    : points_(shader.whole, 1 + int(chance.below(40)), unsigned(chance.bits())),
      seed_(chance.bits()), parameterCount_(int(shader.whole.parameters.size())) {
    points_.setSamples(int(chance.below(4)), unsigned(chance.bits()));
    if (chance.oneIn(3))
        addSpecials(points_.inputs, chance);
    takeSampledRegion(points_.inputs);
    if (chance.oneIn(2))
        for (int word = 0; word < points_.padded() / laneBlock; ++word)
            points_.active.push_back(std::uint16_t(chance.oneIn(4) ? 0 : chance.bits()));
    const bool random = chance.oneIn(3);
    for (const ir::ShaderParameter &parameter : shader.parameters)
        for (std::size_t k = 0; k < parameter.defaults.size() && parameter.firstSlot >= 0; ++k)
            for (int lane = 0; lane < points_.padded() && !random; ++lane)
                points_.parameters[std::size_t(lane * parameterCount_ + parameter.firstSlot) + k] =
                    parameter.defaults[k];
}

float Batch::makeEqual(int slot) {
    const float value = points_.parameters[std::size_t(slot)];
    for (int lane = 0; lane < points_.padded(); ++lane)
        points_.parameters[std::size_t(lane * parameterCount_ + slot)] = value;
    return value;
}

void Batch::fit(const ir::Function &function) {
    Chance chance(seed_);
    const auto samples = std::size_t(function.colors.samples);
    ambient_ = randomPlanes(2 * samples, points_.padded(), chance);
    answers_ = randomPlanes(function.requests.size() * samples, points_.padded(), chance);
}

/// Slices that differentiate read the derivatives of variables, too, behind those of the text.
void Batch::fitVariables(const ir::Function &function) {
    Chance chance(seed_ + 1);
    const std::size_t there = points_.variables.size(), wanted = function.variables.size();
    for (Plane &plane : randomPlanes(wanted > there ? wanted - there : 0, points_.padded(), chance))
        points_.variables.push_back(std::move(plane));
}

RunResult Batch::run(const ir::Function &function, const Code &code, Light light) {
    fitVariables(function);
    RunResult result;
    points_.callbacks = {&result, noteOutside, [](void *context, const char *, std::int32_t) {
                             static_cast<RunResult *>(context)->ended = true;
                         }};
    points_.services.context = &result;
    points_.services[Service::print] = notePrint;
    points_.services[Service::option] = [](void *, const ServiceCall &call) {
        ir::answerService(nullptr, call);
    };
    const auto ambient = pointersTo(ambient_), answers = pointersTo(answers_);
    const auto withLight = [&](const ir::Function &, const ShaderArgs &dark) {
        ShaderArgs args = dark;
        if (light == Light::None) {
            args.sampleCount = 0;
        } else {
            args.ambient = ambient.data();
            args.irradiance = ambient.data() + function.colors.samples;
            args.answers = answers.data();
        }
        code(function, args);
    };
    result.outputs = points_.run(function, withLight, unreached);
    result.frames = points_.frames;
    return result;
}

} // namespace candela::fuzz
