// SPDX-License-Identifier: Apache-2.0
// Shading speed on one thread: shaders as the renderer compiles them, sixteen lanes wide and one
// by one, against the same written by hand. Prints JSON: points a microsecond, a number a round.
#include "shading_cases.h"

#include "foundation/base/instruction_set.h"
#include "language/jit/jit.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <sched.h>

namespace candela::bench {
namespace {

constexpr int points = 1024;
constexpr double secondsARound = 0.01;

double threadSeconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

/// On the processor that it is on: caches stay warm.
void pinThread() {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
}

/// Code that competes: which it is, and how many points a microsecond it shaded in each round.
struct Rival {
    Rival(const char *name, ShaderFunction code) : name(name), code(code) {}
    const char *name;
    ShaderFunction code;
    int calls = 1; ///< Of a round.
    std::vector<double> rates;

    double run(const ShaderArgs &args, int times) const {
        const double start = threadSeconds();
        for (int k = 0; k < times; ++k)
            code(&args);
        return threadSeconds() - start;
    }
    void findCalls(const ShaderArgs &args) {
        while (run(args, calls) < secondsARound)
            calls *= 2;
    }
};

/// In each round all have their turn.
void race(std::vector<Rival> &rivals, ShadingWork &work, int rounds) {
    work.batch.run(work.function, [&](const ir::Function &, const ShaderArgs &args) {
        for (Rival &rival : rivals)
            rival.findCalls(args);
        for (int round = 0; round < rounds; ++round)
            for (Rival &rival : rivals)
                rival.rates.push_back(1e-6 * points * rival.calls / rival.run(args, rival.calls));
    });
}

/// Mean and standard deviation of a plane.
std::pair<double, double> momentsOf(const ir::TestPlane &plane) {
    double sum = 0, squares = 0;
    for (float x : plane)
        sum += x, squares += double(x) * x;
    const double mean = sum / double(plane.size());
    return {mean, std::sqrt(std::max(0.0, squares / double(plane.size()) - mean * mean))};
}

/// Does the code by hand do what is compiled? To rounding, or on the average.
bool agree(const ShadingCase &which, ShadingWork &work, ShaderFunction a, ShaderFunction b) {
    const auto resultOf = [&](ShaderFunction code) {
        return work.batch.run(work.function,
                              [&](const ir::Function &, const ShaderArgs &args) { code(&args); });
    };
    const auto first = resultOf(a), second = resultOf(b);
    for (std::size_t k = 0; k < first.size(); ++k) {
        const auto [mean, deviation] = momentsOf(first[k]);
        const auto [otherMean, otherDeviation] = momentsOf(second[k]);
        if (std::abs(mean - otherMean) > 0.1 * deviation ||
            std::abs(deviation - otherDeviation) > 0.5 * deviation)
            return false;
        for (std::size_t i = 0; i < first[k].size() && !which.ownNoise; ++i)
            if (!(std::abs(first[k][i] - second[k][i]) <= 1e-4f * (1 + std::abs(first[k][i]))))
                return false;
    }
    return true;
}

ShaderFunction byHand(int number) {
    switch (runtime::hostIsaLevel()) {
    case runtime::IsaLevel::V4: return handShaderV4(number);
    case runtime::IsaLevel::V3: return handShaderV3(number);
    default: return nullptr;
    }
}

JitOptions optionsAt(int width) {
    JitOptions options;
    options.width = width;
    options.useCache = false;
    return options;
}

void print(const std::vector<Rival> &rivals) {
    for (const Rival &rival : rivals) {
        std::printf("%s\"%s\": [", &rival == &rivals.front() ? "" : ", ", rival.name);
        for (std::size_t k = 0; k < rival.rates.size(); ++k)
            std::printf("%s%.4g", k ? ", " : "", rival.rates[k]);
        std::printf("]");
    }
}

bool measure(int number, int rounds) {
    const ShadingCase &which = shadingCases[std::size_t(number)];
    DiagnosticList diagnostics;
    auto work = shadingWork(which, points, diagnostics);
    Jit wide(optionsAt(16), diagnostics), narrow(optionsAt(1), diagnostics);
    std::vector<Rival> rivals;
    if (work)
        rivals = {{"compiled", wide.compile(work->function)},
                  {"oneLane", narrow.compile(work->function)}};
    if (!work || !rivals[0].code || !rivals[1].code) {
        std::fprintf(stderr, "%s", diagnostics.text().c_str());
        return false;
    }
    if (const ShaderFunction hand = byHand(number)) {
        if (!agree(which, *work, rivals[0].code, hand)) {
            std::fprintf(stderr, "%s is something else by hand\n", which.name);
            return false;
        }
        rivals.push_back({"byHand", hand});
    }
    race(rivals, *work, rounds);
    std::printf("%s\n  \"%s\": {", number ? "," : "", which.name);
    print(rivals);
    std::printf("}");
    return true;
}

} // namespace
} // namespace candela::bench

int main(int count, char **words) {
    using namespace candela;
    bench::pinThread();
    const int rounds = count > 1 ? std::atoi(words[1]) : 15;
    if (rounds < 1) {
        std::fprintf(stderr, "shading_bench [ROUNDS]\n");
        return 2;
    }
    std::printf("{\"level\": \"%s\", \"shaders\": {", nameOf(instructionSet()));
    for (int k = 0; k < int(bench::shadingCases.size()); ++k)
        if (!bench::measure(k, rounds))
            return 1;
    std::printf("}}\n");
}
