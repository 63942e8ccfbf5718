// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_starts.h"

#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"
#include "world/scene/absent_lamps.h"
#include "world/scene/cone_samples.h"
#include "world/scene/emission_guide.h"
#include "world/scene/emitters.h"
#include "world/scene/light_question.h"
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"
#include "world/scene/source_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;

/// Density of directions from a surface that shines to `sides`, by the cosine with its normal.
double cosineDensity(LightSides sides, double cosine) {
    switch (sides) {
    case LightSides::Front: return cosine > 0 ? cosine / pi : 0;
    case LightSides::Back: return cosine < 0 ? -cosine / pi : 0;
    case LightSides::Both: break;
    }
    return std::fabs(cosine) / (2 * pi);
}

Vec3 sampleCosine(LightSides sides, Vec3 normal, float u, float v) {
    bool back = sides == LightSides::Back;
    if (sides == LightSides::Both) {
        back = u >= 0.5f;
        u = std::min(2 * u - (back ? 1.0f : 0.0f), 0x1.fffffep-1f);
    }
    return directionAbout(back ? -normal : normal, std::sqrt(1 - u), v);
}

/// A light's grid, if it has one, and how many of its paths follow it.
struct Guide {
    const NestedGrid *grid = nullptr;
    double share = 0;

    Guide(const EmissionGuide *all, int light) {
        if (all && all->lights[light])
            grid = &*all->lights[light], share = all->share;
    }

    /// The density of what may follow the grid, or not; `own` without it, `even` what the grid's 1
    /// is.
    double pdf(std::array<double, 2> place, double own, double even) const {
        return grid ? share * grid->pdf(place[0], place[1]) * even + (1 - share) * own : own;
    }

    /// A place on the grid, for the guided part of `number`; else nothing, and the number is
    /// uniform again.
    std::optional<std::array<double, 2>> sample(float &number, float other) const {
        if (!grid)
            return std::nullopt;
        if (number < share)
            return grid->sample(number / share, other);
        number = std::min(float((number - share) / (1 - share)), 0x1.fffffep-1f);
        return std::nullopt;
    }
};

void put(const std::array<float *, 3> &planes, int i, Vec3 value) {
    for (int c = 0; c < 3; ++c)
        planes[c][i] = value[c];
}

/// Paths from the surfaces of one code.
struct SurfaceStarts {
    Planes<float> numbers{2, lightBatchSize}, radiance{colorSamples, lightBatchSize};
    std::vector<std::int32_t> element = std::vector<std::int32_t>(lightBatchSize);
    ElementRows rows{lightBatchSize};
    SourcePoints drawn{lightBatchSize};
    ShadingPoints points{lightBatchSize};
};

class Starter {
public:
    Starter(const SceneState &state, const LightStartNumbers &numbers, const EmissionGuide *guide,
            LightStarts &out)
        : state_(state), numbers_(numbers), guide_(guide), out_(out) {}

    void run(int count) {
        const Emitters &emitters = state_.emitters;
        place_.assign(count, 0);
        std::fill_n(out_.skyPdf, count, 0.0f);
        std::vector<std::vector<int>> byCode(state_.points.codes.size());
        for (int i = 0; i < count; ++i) {
            const int light = choose(i);
            if (light < 0) {
                setNone(i);
                continue;
            }
            switch (emitters.lights[light].form) {
            case EmitterForm::None: setNone(i); break;
            case EmitterForm::Surface: byCode[codeOf(out_.source[i])].push_back(i); break;
            case EmitterForm::Point: startAtPoint(i, light); break;
            case EmitterForm::Distant: distant_.push_back(i); break;
            }
        }
        startFarAway();
        for (int code = 0; code < int(byCode.size()); ++code)
            for (std::size_t first = 0; first < byCode[code].size(); first += lightBatchSize)
                startOnSurfaces(
                    code, std::span(byCode[code])
                              .subspan(first, std::min<std::size_t>(byCode[code].size() - first,
                                                                    lightBatchSize)));
    }

private:
    /// The light; its source and what is left of the number.
    int choose(int i) {
        const std::vector<double> &cumulative =
            guide_ ? guide_->cumulative : state_.emitters.cumulative;
        if (cumulative.empty() || !(cumulative.back() > 0))
            return -1;
        double choice = numbers_.choice[i];
        const int index = chooseByCumulative(cumulative, choice);
        const SceneLight &light = state_.lights.lights[index];
        out_.source[i] = light.firstSource;
        place_[i] = numbers_.position[0][i];
        out_.light[i] = index + 1;
        out_.element[i] = -1;
        if (light.hasGeometry()) {
            double across = place_[i];
            out_.source[i] += chooseByCumulative(light.cumulative, across);
            place_[i] = std::min(float(across), 0x1.fffffep-1f);
        }
        return index;
    }

    void setNone(int i) {
        out_.light[i] = 0;
        out_.source[i] = out_.element[i] = -1;
        put(out_.origin, i, {}), put(out_.direction, i, {0, 0, 1}), put(out_.normal, i, {});
        out_.positionPdf[i] = out_.directionPdf[i] = 0;
        for (float *plane : out_.flux)
            plane[i] = 0;
        out_.lightSample[0][i] = out_.lightSample[1][i] = 0;
    }

    int codeOf(std::int32_t source) const {
        const LightElement &element = state_.lights.firstElementOf(state_.lights.sources[source]);
        return state_.points
            .appearances[state_.points.appearanceOf(element.instance, element.shape)]
            .code;
    }

    double probabilityOf(int light) const {
        return guide_ ? guide_->probability[light] : state_.emitters.lights[light].probability;
    }

    void startAtPoint(int i, int light) {
        const Emitter &emitter = state_.emitters.lights[light];
        const Guide guide(guide_, light);
        float u = numbers_.direction[0][i];
        const float v = numbers_.direction[1][i];
        const auto place = guide.sample(u, v);
        const Vec3 direction =
            place ? directionOfSquare((*place)[0], (*place)[1]) : emitter.lobes.sample(u, v);
        const double probability = probabilityOf(light);
        put(out_.origin, i, emitter.place);
        put(out_.direction, i, direction);
        put(out_.normal, i, {});
        const double directionPdf =
            guide.pdf(squareOfDirection(direction), emitter.lobes.pdf(direction), 1 / (4 * pi));
        out_.positionPdf[i] = float(probability);
        out_.directionPdf[i] = float(directionPdf);
        for (float *plane : out_.flux)
            plane[i] = float(1 / (probability * directionPdf));
        out_.lightSample[0][i] = numbers_.position[0][i];
        out_.lightSample[1][i] = numbers_.position[1][i];
    }

    /// Distant lights are asked for the way that they shine in the scene's middle.
    void startFarAway() {
        for (std::size_t first = 0; first < distant_.size(); first += lightBatchSize) {
            const int count = int(std::min<std::size_t>(distant_.size() - first, lightBatchSize));
            const int *lane = distant_.data() + first;
            askDirections(lane, count);
            for (int k = 0; k < count; ++k)
                startThroughDisc(lane[k],
                                 normalize(Vec3{batch_.L[0][k], batch_.L[1][k], batch_.L[2][k]}));
        }
    }

    void askDirections(const int *lane, int count) {
        batch_.prints = false;
        // Lights of one shader are asked together; there are few distant ones.
        for (int first = 0; first < count;) {
            const ShaderCode *code = shaderOf(lane[first]);
            int last = first;
            batch_.count = 0;
            for (; last < count && shaderOf(lane[last]) == code; ++last)
                prepare(lane[last], batch_.count++);
            const int asked = batch_.count;
            batch_.ask(state_, *code);
            for (int c = 0; c < 3; ++c)
                std::copy_n(batch_.L[c], asked, direction_[c] + first);
            first = last;
        }
        for (int c = 0; c < 3; ++c)
            std::copy_n(direction_[c], count, batch_.L[c]);
    }

    const ShaderCode *shaderOf(int i) const {
        return state_.lights.lights[out_.light[i] - 1].shader.code.get();
    }

    void prepare(int i, int lane) {
        const SceneLight &light = state_.lights.lights[out_.light[i] - 1];
        placePointLight(batch_, lane, light, state_.points.shutter);
        batch_.parameterOffset[lane] = light.shader.parameterOffset;
        batch_.objectIndex[lane] = 0;
        for (int c = 0; c < 3; ++c)
            batch_.input(ShaderInput::Ps, c)[lane] = state_.centre[c];
        for (int c = 0; c < 2; ++c)
            out_.lightSample[c][i] = batch_.input(ShaderInput::lightSample, c)[lane] =
                numbers_.direction[c][i];
    }

    void startThroughDisc(int i, Vec3 direction) {
        if (!isFinite(direction) || dot(direction, direction) == 0)
            return setNone(i);
        const double probability = probabilityOf(out_.light[i] - 1);
        const Guide guide(guide_, out_.light[i] - 1);
        float u = numbers_.position[0][i], v = numbers_.position[1][i];
        if (const auto place = guide.sample(u, v))
            u = float((*place)[0]), v = float((*place)[1]);
        const Vec3 across = directionAbout(direction, 0, v);
        const float radius = state_.radius * std::sqrt(u);
        const double pdf =
            guide.pdf({u, v}, 1 / state_.emitters.discArea, 1 / state_.emitters.discArea);
        put(out_.origin, i, state_.centre + across * radius - direction * (2 * state_.radius));
        put(out_.direction, i, direction);
        put(out_.normal, i, {});
        out_.positionPdf[i] = float(probability);
        out_.directionPdf[i] = float(pdf);
        if (const auto &sky = state_.lights.lights[out_.light[i] - 1].sky)
            out_.skyPdf[i] = float(sky->pdfOfDrawn(out_.lightSample[0][i], direction));
        for (float *plane : out_.flux)
            plane[i] = float(1 / (pdf * probability));
    }

    void startOnSurfaces(int code, std::span<const int> lane) {
        thread_local SurfaceStarts own;
        const int count = int(lane.size());
        const LightTable &table = state_.lights;
        for (int k = 0; k < count; ++k) {
            const int i = lane[k];
            own.numbers[0][k] = place_[i];
            own.numbers[1][k] = numbers_.position[1][i];
            own.element[k] = out_.element[i] =
                table.drawElement(table.sources[out_.source[i]], own.numbers[0][k]);
        }
        own.rows.take(table, count, own.element.data());
        placeOnElements(own.rows, own.numbers[0], own.numbers[1], own.drawn);
        placePoints(own.rows, own.drawn, own.points);
        ShadingPoints &points = own.points;
        for (ShaderInput input : {ShaderInput::I, ShaderInput::E})
            for (int c = 0; c < 3; ++c)
                std::fill_n(points.input(input, c), count, 0.0f);
        std::fill_n(points.input(ShaderInput::time, 0), count, state_.options.camera.shutterOpen);
        evaluatePoints(state_.points, state_.camera, state_.points.codes[code], nullptr, points);
        for (int k = 0; k < count; ++k)
            sendFrom(own, k, lane[k]);
        float *radiance[colorSamples];
        for (int c = 0; c < colorSamples; ++c)
            std::fill_n(radiance[c] = own.radiance[c], count, 0.0f);
        state_.emission(code, points, radiance, false);
        for (int k = 0; k < count; ++k)
            for (int c = 0; c < colorSamples; ++c)
                out_.flux[c][lane[k]] *= radiance[c][k];
        std::uint8_t isThere[lightBatchSize];
        if (findAbsent(state_, own.rows, own.drawn, points.input(ShaderInput::time, 0), isThere))
            for (int k = 0; k < count; ++k)
                if (!isThere[k])
                    setNone(lane[k]);
    }

    /// Direction and densities of path i, which begins at point k; the flux of unit radiance.
    void sendFrom(SurfaceStarts &own, int k, int i) {
        ShadingPoints &points = own.points;
        const auto vec3 = [&](ShaderInput input) {
            return Vec3{points.input(input, 0)[k], points.input(input, 1)[k],
                        points.input(input, 2)[k]};
        };
        const Vec3 P = vec3(ShaderInput::P), Ng = vec3(ShaderInput::Ng);
        const Emitter &emitter = state_.emitters.lights[out_.light[i] - 1];
        const int light = out_.light[i] - 1;
        const Vec3 direction =
            sampleCosine(emitter.sides, Ng, numbers_.direction[0][i], numbers_.direction[1][i]);
        for (int c = 0; c < 3; ++c)
            points.input(ShaderInput::I, c)[k] = -direction[c];
        put(out_.origin, i, Scene::offsetOrigin(P, Ng, direction, points.offset[k]));
        put(out_.direction, i, direction);
        put(out_.normal, i, Ng);
        const double cosine = dot(direction, Ng);
        const double directionPdf = cosineDensity(emitter.sides, cosine);
        const double positionPdf = probabilityOf(light) / emitter.area;
        // Those that turn their back where rays do not meet it send nothing there.
        const SourceBin &bin = state_.lights.bins[state_.lights.sources[out_.source[i]].bin];
        const Vec3 natural{own.drawn.normal[0][k], own.drawn.normal[1][k], own.drawn.normal[2][k]};
        const bool sends = dot(direction, natural) * bin.frontSign >= 0 && directionPdf > 0;
        const double flux = sends ? std::fabs(cosine) / (directionPdf * positionPdf) : 0;
        out_.positionPdf[i] = float(positionPdf), out_.directionPdf[i] = float(directionPdf);
        for (float *plane : out_.flux)
            plane[i] = float(flux);
        out_.lightSample[0][i] = out_.lightSample[1][i] = 0;
    }

    const SceneState &state_;
    const LightStartNumbers &numbers_;
    const EmissionGuide *guide_;
    LightStarts &out_;
    std::vector<float> place_; ///< What is left of the first number of the place.
    std::vector<int> distant_;
    LightBatch batch_{lightBatchSize};
    Planes<float> direction_{3, lightBatchSize};
};

} // namespace

LightStarts::LightStarts(int capacity)
    : floats(14 + colorSamples, capacity), integers(3, capacity) {
    light = integers[0], source = integers[1], element = integers[2];
    for (int c = 0; c < 3; ++c)
        origin[c] = floats[c], direction[c] = floats[3 + c], normal[c] = floats[6 + c];
    positionPdf = floats[9], directionPdf = floats[10];
    lightSample = {floats[11], floats[12]};
    skyPdf = floats[13];
    for (int c = 0; c < colorSamples; ++c)
        flux[c] = floats[14 + c];
}

bool Lights::startPaths() const {
    const std::vector<double> &cumulative = state_->emitters.cumulative;
    return !cumulative.empty() && cumulative.back() > 0;
}

void Lights::start(int count, const LightStartNumbers &numbers, const EmissionGuide *guide,
                   LightStarts &out) const {
    Starter(*state_, numbers, guide, out).run(count);
}

namespace {

/// Where the line through P along the light's direction passes the disc; directionAbout()'s turn.
std::array<double, 2> squareOfDisc(const SceneState &state, Vec3 direction, Vec3 P) {
    const Vec3 from = P - state.centre;
    const Vec3 x = directionAbout(direction, 0, 0), y = directionAbout(direction, 0, 0.25f);
    const double a = dot(from, x) / state.radius, b = dot(from, y) / state.radius;
    const double turn = std::atan2(b, a) / (2 * pi);
    return {std::min(a * a + b * b, 1.0), turn < 0 ? turn + 1 : turn};
}

} // namespace

void Lights::startDensities(int count, const std::int32_t *light,
                            const std::array<const float *, 3> &direction,
                            const std::array<const float *, 3> &normal,
                            const std::array<const float *, 3> &P, const EmissionGuide *guide,
                            const LightStartDensities &out) const {
    for (int i = 0; i < count; ++i) {
        out.position[i] = out.direction[i] = 0;
        if (light[i] <= 0)
            continue;
        const int index = light[i] - 1;
        const Emitter &emitter = state_->emitters.lights[index];
        const Guide own(guide, index);
        const double probability = guide ? guide->probability[index] : emitter.probability;
        const Vec3 along{direction[0][i], direction[1][i], direction[2][i]};
        const Vec3 N{normal[0][i], normal[1][i], normal[2][i]};
        double pdf = 0;
        switch (emitter.form) {
        case EmitterForm::None: continue;
        case EmitterForm::Surface: pdf = cosineDensity(emitter.sides, dot(along, N)); break;
        case EmitterForm::Point:
            pdf = own.pdf(squareOfDirection(along), emitter.lobes.pdf(along), 1 / (4 * pi));
            break;
        case EmitterForm::Distant:
            pdf = 1 / state_->emitters.discArea;
            pdf = own.pdf(squareOfDisc(*state_, along, {P[0][i], P[1][i], P[2][i]}), pdf, pdf);
        }
        const bool hasArea = emitter.form == EmitterForm::Surface;
        out.position[i] = float(hasArea ? probability / emitter.area : probability);
        out.direction[i] = float(pdf);
    }
}

std::optional<std::array<double, 2>> Lights::guidedPlace(std::int32_t light, const Vec3 &direction,
                                                         const Vec3 &P) const {
    switch (state_->emitters.lights[light - 1].form) {
    case EmitterForm::None:
    case EmitterForm::Surface: return std::nullopt;
    case EmitterForm::Point: return squareOfDirection(direction);
    case EmitterForm::Distant: break;
    }
    return squareOfDisc(*state_, direction, P);
}

std::optional<std::array<double, 2>> Lights::guidedPlaceFor(std::int32_t light,
                                                            const Vec3 &P) const {
    const Emitter &emitter = state_->emitters.lights[light - 1];
    if (emitter.form != EmitterForm::Point)
        return std::nullopt;
    return squareOfDirection(normalize(P - emitter.place));
}

double Lights::typicalRadiance() const {
    double power = 0;
    for (const SceneLight &light : state_->lights.lights)
        power += light.power;
    const double area = 4 * pi * double(state_->radius) * state_->radius;
    return area > 0 && std::isfinite(power) ? power / (pi * area) : 0;
}

std::vector<double> Lights::startProbabilities() const {
    std::vector<double> all;
    for (const Emitter &emitter : state_->emitters.lights)
        all.push_back(emitter.probability);
    return all;
}

bool Lights::isDistant(std::int32_t light) const {
    return light > 0 && state_->lights.lights[light - 1].kind == LightKind::Distant;
}

} // namespace candela
