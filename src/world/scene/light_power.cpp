// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_power.h"

#include "world/scene/light_question.h"
#include "world/scene/source_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int mostSamples = 256, leastSamples = 16;
/// Questions to all lights of a group together, beyond which each is asked less often.
constexpr int questionBudget = 1 << 19;
/// Questions that tell where a light without geometry stands.
constexpr int placeSamples = 4;

/// Additive recurrences on powers of the plastic number: four well spread dimensions.
float quasiRandom(int i, int dimension) {
    constexpr double steps[] = {0.8566748838545029, 0.733891856627126, 0.6287067210378087,
                                0.5385972572236101};
    double value = 0.5 + (i + 1) * steps[dimension];
    return float(value - std::floor(value));
}

Vec3 onSphere(float a, float b) {
    float z = 1 - 2 * a, r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(2 * pi * b), r * std::sin(2 * pi * b), z};
}

Vec3 direction(int i) { return onSphere(quasiRandom(i, 0), quasiRandom(i, 1)); }

Vec3 get(const LightBatch &batch, ShaderInput input, int lane) {
    return {batch.input(input, 0)[lane], batch.input(input, 1)[lane], batch.input(input, 2)[lane]};
}

void set(LightBatch &batch, ShaderInput input, int lane, Vec3 value) {
    for (int c = 0; c < 3; ++c)
        batch.input(input, c)[lane] = value[c];
}

Vec3 vectorL(const LightBatch &batch, int lane) {
    return {batch.L[0][lane], batch.L[1][lane], batch.L[2][lane]};
}

/// How much there is of a light's answer; lights may take away as well. What is not finite counts
/// as 0, as it does where light is sampled.
double amount(float answer) { return std::isfinite(answer) ? std::fabs(answer) : 0.0; }

/// Sum of Cl's color samples.
double totalCl(const LightBatch &batch, int lane) {
    double total = 0;
    for (int c = 0; c < colorSamples; ++c)
        total += amount(batch.Cl[c][lane]);
    return total;
}

/// The code of the surface that the source's first element lies on.
std::int32_t codeOf(const SceneState &state, std::int32_t source) {
    const LightElement &element = state.lights.firstElementOf(state.lights.sources[source]);
    const PointTables &points = state.points;
    return points.appearances[points.appearanceOf(element.instance, element.shape)].code;
}

/// Without extent, classic units are what a white diffuser sends. The tree adds powers up as
/// floats.
void setPower(SceneLight &light, double power) {
    constexpr double most = 1e30;
    if (!light.finite() && !light.si)
        power *= pi;
    light.power = power > 0 ? std::min(power, most) : 0;
}

/// A cone about the directions that are lit, if it is narrow and enough of them are; of the lanes
/// [first, first + samples).
void findBeam(const LightBatch &batch, int first, int samples, SceneLight &light) {
    constexpr int enough = 6;
    const float apart = 2.2f / std::sqrt(float(samples)); // Of neighbouring directions.
    auto forLit = [&](auto body) {
        for (int lane = first; lane < first + samples; ++lane)
            if (totalCl(batch, lane) > 0)
                body(normalize(vectorL(batch, lane)));
    };
    Vec3 sum;
    int lit = 0;
    forLit([&](Vec3 d) { sum += d, ++lit; });
    const Vec3 axis = normalize(sum);
    float least = 1;
    forLit([&](Vec3 d) { least = std::min(least, dot(axis, d)); });
    const float spread = std::acos(std::clamp(least, -1.0f, 1.0f)) + apart;
    const bool narrow = lit >= enough && spread < pi / 2;
    light.axis = narrow ? axis : Vec3{};
    light.spread = narrow ? spread : pi;
}

/// Points on lights, as shading points.
struct PlacedSamples {
    ElementRows rows{lightBatchSize};
    SourcePoints drawn{lightBatchSize};
    ShadingPoints points{lightBatchSize};

    /// One on each of the sources, uniform by area.
    void place(const SceneState &state, const SurfaceCode &code, int count,
               const std::int32_t *source, const float *u, const float *v) {
        rows.draw(state.lights, count, source, u);
        placeOnElements(rows, rows.u, v, drawn);
        placePoints(rows, drawn, points);
        for (ShaderInput input : {ShaderInput::I, ShaderInput::E})
            for (int c = 0; c < 3; ++c)
                std::fill_n(points.input(input, c), count, 0.0f);
        std::fill_n(points.input(ShaderInput::time, 0), count, state.camera.shutterOpen());
        evaluatePoints(state.points, state.camera, code, nullptr, points);
    }

    /// A cosine-distributed viewer of the point by quasi-random number i: even ones in front, odd
    /// ones behind.
    void placeViewer(int lane, int i) {
        Vec3 Ng;
        for (int c = 0; c < 3; ++c)
            Ng[c] = points.input(ShaderInput::Ng, c)[lane];
        // A unit vector added to the normal has the cosine distribution about it.
        const Vec3 way = normalize(Ng + onSphere(quasiRandom(i, 2), quasiRandom(i, 3)));
        for (int c = 0; c < 3; ++c)
            points.input(ShaderInput::I, c)[lane] = i % 2 ? way[c] : -way[c];
    }
};

/// Asks a few lights at a time, all of one shader; lane k * samples + i is sample i of light k.
class Estimator {
public:
    explicit Estimator(SceneState &state) : state_(state) { batch_.prints = false; }

    void estimate(LightKind kind, std::span<const int> group) {
        const int share = questionBudget / int(group.size());
        samples_ = std::clamp(int(std::bit_floor(unsigned(share))), leastSamples, mostSamples);
        const std::size_t together = lightBatchSize / samples_;
        for (std::size_t first = 0; first < group.size(); first += together) {
            group_ = group.subspan(first, std::min(together, group.size() - first));
            switch (kind) {
            case LightKind::None:
            case LightKind::Ambient: break;
            case LightKind::Area:
            case LightKind::Emitter: askSurfaces(); break;
            case LightKind::Distant: askDistant(); break;
            case LightKind::Point: askPoints(); break;
            case LightKind::ClassicArea: askClassicAreas(); break;
            }
        }
    }

private:
    SceneLight &light(int k) const { return state_.lights.lights[group_[k]]; }
    int lights() const { return int(group_.size()); }

    /// Calls body(light's number, its sample, lane).
    template <class Body> void forLanes(int samples, Body body) const {
        for (int k = 0; k < lights(); ++k)
            for (int i = 0; i < samples; ++i)
                body(k, i, k * samples + i);
    }

    void prepare(int samples) {
        batch_.hasSurface = false;
        batch_.count = samples * lights();
        forLanes(samples, [&](int k, int i, int lane) {
            batch_.input(ShaderInput::time)[lane] = state_.camera.shutterOpen();
            placePointLight(batch_, lane, light(k), state_.points.shutter);
            batch_.parameterOffset[lane] = light(k).shader.parameterOffset;
            batch_.objectIndex[lane] = 0;
            for (int c = 0; c < 2; ++c)
                batch_.input(ShaderInput::lightSample, c)[lane] = quasiRandom(i, 2 + c);
        });
    }

    void ask() { batch_.ask(state_, *light(0).shader.code); }

    void askFromAround(int samples) {
        forLanes(samples, [&](int, int i, int lane) {
            set(batch_, ShaderInput::Ps, lane, state_.centre + direction(i) * state_.radius);
        });
        ask();
    }

    void askDistant() {
        prepare(samples_);
        askFromAround(samples_);
        std::vector<double> sums(lights());
        forLanes(samples_, [&](int k, int, int lane) { sums[k] += totalCl(batch_, lane); });
        for (int k = 0; k < lights(); ++k)
            setPower(light(k), sums[k] / samples_ * pi * state_.radius * state_.radius);
    }

    /// Where they stand is where L comes from; then from all directions.
    void askPoints() {
        std::vector<Vec3> centres(lights());
        for (int k = 0; k < lights(); ++k) {
            light(k).place = {};
            centres[k] = transformPoint(light(k).currentFromShader, {0, 0, 0});
        }
        prepare(placeSamples);
        askFromAround(placeSamples);
        findPlaces(placeSamples);
        for (int k = 0; k < lights(); ++k)
            if (!light(k).place.empty())
                centres[k] = light(k).place.centre();
        prepare(samples_);
        askAbout([&](int k, int) { return centres[k]; });
        findPlaces(samples_);
        for (int k = 0; k < lights(); ++k)
            findBeam(batch_, k * samples_, samples_, light(k));
    }

    void findPlaces(int samples) {
        forLanes(samples, [&](int k, int, int lane) {
            const Vec3 L = vectorL(batch_, lane), at = get(batch_, ShaderInput::Ps, lane) - L;
            if (dot(L, L) > 0 && isFinite(at))
                light(k).place.add(at);
        });
    }

    /// Intensities over the sphere around each light.
    template <class Centre> void askAbout(Centre centre) {
        forLanes(samples_, [&](int k, int i, int lane) {
            set(batch_, ShaderInput::Ps, lane, centre(k, lane) + direction(i) * state_.radius);
        });
        ask();
        std::vector<double> sums(lights());
        forLanes(samples_, [&](int k, int, int lane) {
            const Vec3 L = vectorL(batch_, lane);
            const double squared = double(L.x) * L.x + double(L.y) * L.y + double(L.z) * L.z;
            sums[k] += totalCl(batch_, lane) * squared;
        });
        for (int k = 0; k < lights(); ++k)
            setPower(light(k), sums[k] / samples_ * 4 * pi);
    }

    /// Where a light's shapes have other codes, those of the first one stand for all.
    void place(const SurfaceCode &code) {
        std::int32_t source[lightBatchSize];
        float u[lightBatchSize], v[lightBatchSize];
        forLanes(samples_, [&](int k, int i, int lane) {
            double choice = (i + 0.5) / samples_;
            const std::int32_t first = light(k).firstSource;
            source[lane] = first + chooseByCumulative(light(k).cumulative, choice);
            if (codeOf(state_, source[lane]) != codeOf(state_, first))
                source[lane] = first;
            u[lane] = quasiRandom(i, 0), v[lane] = quasiRandom(i, 1);
        });
        placed_.place(state_, code, samples_ * lights(), source, u, v);
    }

    /// Sums of what the placed points send, in front and behind.
    std::vector<std::array<double, 2>> sumsOfEmission(int code) {
        float *radiance[colorSamples];
        for (int c = 0; c < colorSamples; ++c)
            std::fill_n(radiance[c] = radiance_[c], lightBatchSize, 0.0f);
        state_.emission(code, placed_.points, radiance, batch_.prints);
        std::vector<std::array<double, 2>> sums(lights());
        forLanes(samples_, [&](int k, int i, int lane) {
            for (int c = 0; c < colorSamples; ++c)
                sums[k][i % 2] += amount(radiance[c][lane]);
        });
        return sums;
    }

    /// Radiant exitance of both sides times area.
    void askSurfaces() {
        const int code = codeOf(state_, light(0).firstSource);
        place(state_.points.codes[code]);
        forLanes(samples_, [&](int, int i, int lane) { placed_.placeViewer(lane, i); });
        const std::vector<std::array<double, 2>> sums = sumsOfEmission(code);
        for (int k = 0; k < lights(); ++k) {
            const auto [front, back] = sums[k];
            setPower(light(k), (front + back) / samples_ * 2 * pi * light(k).area);
            light(k).sides = front > 0 && back == 0   ? LightSides::Front
                             : back > 0 && front == 0 ? LightSides::Back
                                                      : LightSides::Both;
        }
        if (state_.points.codes[code].code->facts().emits)
            findSurfaceRadiance(code);
    }

    /// Of area lights: of points that belong to no light surfaces alone send.
    void findSurfaceRadiance(int code) {
        std::fill_n(placed_.points.light, placed_.points.count, 0);
        const std::vector<std::array<double, 2>> sums = sumsOfEmission(code);
        for (int k = 0; k < lights(); ++k)
            if (light(k).kind == LightKind::Area)
                light(k).surfaceRadiance = (sums[k][0] + sums[k][1]) / (samples_ * colorSamples);
    }

    /// Classic area lights are told by their shader how to fall off: what arrives at the rim of the
    /// scene counts.
    void askClassicAreas() {
        prepare(samples_);
        batch_.hasSurface = true;
        place(SurfaceCode{});
        for (ShaderInput input : {ShaderInput::P, ShaderInput::N, ShaderInput::Ng})
            for (int c = 0; c < 3; ++c)
                std::copy_n(placed_.points.input(input, c), batch_.count, batch_.input(input, c));
        askAbout([&](int, int lane) { return get(batch_, ShaderInput::P, lane); });
    }

    SceneState &state_;
    std::span<const int> group_;
    int samples_ = mostSamples;
    LightBatch batch_{lightBatchSize};
    PlacedSamples placed_;
    Planes<float> radiance_{colorSamples, lightBatchSize};
};

/// Lights that are asked together have kind and shader in common: that of the surface, if it tells.
std::pair<LightKind, const void *> groupOf(const SceneState &state, const SceneLight &light) {
    if (!light.finite())
        return {light.kind, light.shader.code.get()};
    return {LightKind::Area, &state.points.codes[codeOf(state, light.firstSource)]};
}

} // namespace

void estimateLights(SceneState &state) {
    std::map<std::pair<LightKind, const void *>, std::vector<int>> groups;
    for (std::size_t i = 0; i < state.lights.lights.size(); ++i)
        if (state.lights.lights[i].isSampled())
            groups[groupOf(state, state.lights.lights[i])].push_back(int(i));
    Estimator estimator(state);
    for (const auto &[key, group] : groups)
        estimator.estimate(key.first, group);
}

} // namespace candela
