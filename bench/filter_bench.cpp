// SPDX-License-Identifier: Apache-2.0
// Filters over 3840 x 2160 pixels (nlmeans: 960 x 540) on all cores, as they are compiled and by
// hand, in turn. Prints JSON: milliseconds, a number a round.
#include "by_hand/filters.h"

#include "foundation/base/instruction_set.h"
#include "foundation/base/parallel.h"
#include "image/filter/filter_stack.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace candela::bench {
namespace {

double milliseconds() {
    using namespace std::chrono;
    return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

OwnedImage picture(int width, int height, int channels) {
    OwnedImage image(width, height, channels);
    parallelFor(std::size_t(height), [&](std::size_t y) {
        for (int c = 0; c < channels; ++c)
            for (int x = 0; x < width; ++x)
                image.row(c, int(y))[x] = float((x * 7 + int(y) * 13 + c * 5) % 97) / 97;
    });
    return image;
}

struct Times {
    std::vector<double> compiled, byHand;
};

void print(const char *name, const std::vector<double> &values, bool isLast) {
    std::printf("\"%s\": [", name);
    for (std::size_t k = 0; k < values.size(); ++k)
        std::printf("%s%.4g", k ? ", " : "", values[k]);
    std::printf("]%s", isLast ? "" : ", ");
}

/// How far two pictures are apart, over how bright they are.
double difference(const OwnedImage &a, const OwnedImage &b) {
    double most = 0, brightest = 0;
    for (int c = 0; c < 3; ++c)
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) {
                most = std::max(most, std::abs(double(a.row(c, y)[x]) - double(b.row(c, y)[x])));
                brightest = std::max(brightest, std::abs(double(a.row(c, y)[x])));
            }
    return most / brightest;
}

class FilterRace {
public:
    FilterRace(const std::string &name, int width, int height)
        : library_({{std::string(CANDELA_SOURCE_DIR) + "/shaders/filter",
                     std::string(CANDELA_SOURCE_DIR) + "/bench/shaders"},
                    {},
                    {}},
                   diagnostics_),
          stack_({record(name)}, library_, {}), given_(picture(width, height, 3)) {
        maps_.set("Ci", picture(width, height, 3));
        for (const std::string &map : stack_.mapsRead())
            maps_.set(map, picture(width, height, map == "id" || map == "Z" ? 1 : 3));
    }

    Times run(int rounds, HandFilter byHand) {
        Times times;
        OwnedImage made(given_.width(), given_.height(), 3);
        for (int round = 0; round <= rounds; ++round) { // The first one is for caches and memory.
            maps_.find("Ci")->takeValues(given_);
            double start = milliseconds();
            stack_.run(maps_, {diagnostics_, {}, {}});
            if (round > 0)
                times.compiled.push_back(milliseconds() - start);
            if (!byHand)
                continue;
            start = milliseconds();
            byHand(given_.view(), made.view());
            if (round > 0)
                times.byHand.push_back(milliseconds() - start);
        }
        if (byHand && difference(*maps_.find("Ci"), made) > 1e-4)
            std::fprintf(stderr, "what is compiled and what is by hand differ by %g\n",
                         difference(*maps_.find("Ci"), made));
        if (!diagnostics_.all().empty() || stack_.empty())
            std::fprintf(stderr, "%s", diagnostics_.text().c_str()), std::exit(1);
        return times;
    }

private:
    static ShaderRecord record(const std::string &name) {
        ShaderRecord record;
        record.name = name;
        return record;
    }

    DiagnosticList diagnostics_;
    ShaderLibrary library_;
    FilterStack stack_;
    OwnedImage given_;
    ImageMaps maps_;
};

void report(const char *name, int width, int height, int rounds, HandFilter byHand, bool isLast) {
    const Times times = FilterRace(name, width, height).run(rounds, byHand);
    std::printf("  \"%s\": {\"pixels\": %d, ", name, width * height);
    print("compiledMs", times.compiled, false);
    print("byHandMs", times.byHand, true);
    std::printf("}%s\n", isLast ? "" : ",");
}

} // namespace
} // namespace candela::bench

int main(int argc, char **argv) {
    using namespace candela;
    using namespace candela::bench;
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 15;
    const auto level = runtime::hostIsaLevel();
    const HandFilters &byHand = level == runtime::IsaLevel::V4 ? handFiltersV4() : handFiltersV3();
    std::printf("{\"level\": \"%s\", \"threads\": %d, \"filters\": {\n", nameOf(instructionSet()),
                threadCount());
    report("ward94", 3840, 2160, rounds, byHand.ward94, false);
    report("box21", 1920, 1080, rounds, byHand.box21, false);
    report("nlmeans", 960, 540, std::max(1, rounds / 5), nullptr, true);
    std::printf("}}\n");
    return 0;
}
