// SPDX-License-Identifier: Apache-2.0
// rib_rate: how fast RIB is read, without anything being made of it: MB a CPU second of one thread,
// the best of several rounds. Two texts: a mesh, which is numbers, and a forest, which is short
// requests; each in ASCII and binary. Or the RIB files that are named. Prints JSON.
#include "foundation/base/whole_file.h"
#include "interface/rib/rib_stream.h"
#include "interface/rib/rib_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>

namespace candela::bench {
namespace {

constexpr int rounds = 5;

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// Hears requests and does nothing.
class Listener final : public StatelessSink {
public:
    std::size_t requests = 0;

#define HEARD(Name, handler, ...)                                                                  \
    void handler(const SourceLocation &CANDELA_PARAMETER_TYPES(__VA_ARGS__)) override {            \
        ++requests;                                                                                \
    }
#define REQUEST(Name, handler, scopes, ...) HEARD(Name, handler, __VA_ARGS__)
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...) HEARD(Name, handler, __VA_ARGS__)
#define REQUEST_OF_STREAM(Name, handler, scopes, ...) HEARD(Name, handler, __VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) HEARD(Name, handler, __VA_ARGS__)
#include "interface/ri/requests.def"
};

/// A rolling ground of a million triangles, with normals.
void mesh(StreamSink &sink) {
    constexpr int side = 708;
    Integers counts, vertices;
    Floats P, N;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const float height = std::sin(float(x) * .1f) * std::cos(float(y) * .07f);
            P.insert(P.end(), {float(x) * .01f, height, float(y) * .01f});
            N.insert(N.end(), {-height * .3f, .9f, height * .2f});
            const int corner = y * side + x;
            if (x + 1 < side && y + 1 < side) {
                counts.insert(counts.end(), {3, 3});
                vertices.insert(vertices.end(), {corner, corner + 1, corner + side, corner + 1,
                                                 corner + side + 1, corner + side});
            }
        }
    sink.pointsPolygons({}, counts, vertices,
                        {{{"P", {}, std::move(P), {}}, {"N", {}, std::move(N), {}}}});
}

/// Trees that are placed one by one.
void forest(StreamSink &sink) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> within(-100, 100);
    for (int i = 0; i < 100'000; ++i) {
        sink.attributeBegin({});
        sink.color({}, Color(.2f, within(random) * .01f, .1f));
        Matrix4 matrix;
        matrix.at(3, 0) = within(random), matrix.at(3, 2) = within(random);
        sink.concatTransform({}, matrix);
        sink.rotate({}, within(random), 0, 1, 0);
        sink.objectInstance({}, {"tree" + std::to_string(i % 20)});
        sink.attributeEnd({});
    }
}

/// Reads it round by round.
void measure(const std::string &name, const std::string &rib, bool last) {
    DiagnosticList found;
    double best = 1e30;
    std::size_t heard = 0;
    for (int round = 0; round < rounds; ++round) {
        std::string copy = rib;
        Listener listener;
        const double start = cpuSeconds();
        readRibText(std::move(copy), "bench.rib", listener, found);
        best = std::min(best, cpuSeconds() - start);
        heard = listener.requests;
    }
    std::printf("  \"%s\": {\"megabytes\": %.1f, \"requests\": %zu, \"megabytesPerSecond\": %.1f, "
                "\"nanosecondsPerRequest\": %.0f}%s\n",
                name.c_str(), double(rib.size()) * 1e-6, heard, double(rib.size()) * 1e-6 / best,
                best * 1e9 / double(heard), last ? "" : ",");
    if (found.count(Severity::Error))
        std::fputs(found.text().c_str(), stderr);
}

void measureWritten(const char *name, void (*requests)(StreamSink &), RibEncoding encoding,
                    bool last) {
    std::string rib;
    const auto output = ByteOutput::toMemory(rib);
    {
        RibWriter writer(*output, encoding);
        requests(writer);
    }
    measure(std::string(name) + (encoding == RibEncoding::Ascii ? "Ascii" : "Binary"), rib, last);
}

bool measureFile(const std::string &file, bool last) {
    std::string problem;
    const auto rib = readWholeFile(file, problem);
    if (!rib) {
        std::fprintf(stderr, "rib_rate: %s\n", problem.c_str());
        return false;
    }
    measure(file, *rib, last);
    return true;
}

} // namespace
} // namespace candela::bench

int main(int count, char **words) {
    using namespace candela;
    std::puts("{");
    bool good = true;
    for (int i = 1; i < count; ++i)
        good &= bench::measureFile(words[i], i + 1 == count);
    if (count == 1) {
        bench::measureWritten("mesh", bench::mesh, RibEncoding::Ascii, false);
        bench::measureWritten("mesh", bench::mesh, RibEncoding::Binary, false);
        bench::measureWritten("forest", bench::forest, RibEncoding::Ascii, false);
        bench::measureWritten("forest", bench::forest, RibEncoding::Binary, true);
    }
    std::puts("}");
    return good ? 0 : 1;
}
