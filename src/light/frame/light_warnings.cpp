// SPDX-License-Identifier: Apache-2.0
#include "light/frame/light_warnings.h"

#include "light/frame/closed_sky.h"

#include <fmt/format.h>

namespace candela {

/// Of more distant lights the first are looked at: a second's work.
static constexpr int mostDistantLights = 256;

/// Surfaces of lamps that send less than this share of their light are no matter.
static constexpr double noMatter = 1e-3;

/// What is wrong with a light; empty if nothing is. `classic` shows lamps by their surfaces alone.
static std::string flawOf(const LightFacts &light, bool isClassic) {
    if (light.lacksShapes)
        return " gives no light: no primitive stands between its AreaLightSource and the end of "
               "its "
               "block";
    if (light.isThere && !light.isEverOn && !light.isTurnedOff)
        return " shines on nothing, unless on its own shapes: a light is on to the end of the "
               "block "
               "that it stands in; Illuminate turns it on elsewhere";
    if (light.surfaceShare > noMatter && !isClassic)
        return fmt::format(
            ": the surface shader of its shapes adds light of its own, {:.3g} "
            "W m^-2 sr^-1; with another one, as \"matte\", or Color 0 0 0, the light "
            "alone shines",
            light.surfaceRadiance);
    return {};
}

static std::string flawOfDistant(const Scene &scene, int index) {
    const int sky = closedSkyBefore(scene, index);
    if (sky < 0)
        return {};
    const LightFacts closed = scene.lights().facts(sky);
    const std::string where = closed.where.text();
    return fmt::format(" is shut out: {}{} shines around everything, and nothing comes through it "
                       "from farther away; Attribute \"visibility\" \"int shadow\" 0 there "
                       "lets it pass",
                       closed.title, where.empty() ? "" : " (" + where + ")");
}

void warnOfLights(const Scene &scene, DiagnosticSink &diagnostics) {
    if (scene.bound().empty()) // Nothing to shine on: nothing to say of lights.
        return;
    const Lights lights = scene.lights();
    int distant = 0;
    for (int index = 0; index < lights.count(); ++index) {
        const LightFacts light = lights.facts(index);
        std::string flaw = flawOf(light, scene.isClassic());
        if (flaw.empty() && light.isThere && light.castsShadow && lights.isDistant(index + 1) &&
            distant++ < mostDistantLights)
            flaw = flawOfDistant(scene, index);
        if (!flaw.empty())
            diagnostics.warning(light.where, light.title + flaw);
    }
}

bool lightsCastNoShadows(const Scene &scene) {
    const Lights lights = scene.lights();
    bool anyShinesThrough = false;
    for (int index = 0; index < lights.count(); ++index) {
        const LightFacts light = lights.facts(index);
        if (light.castsShadow)
            return false;
        anyShinesThrough |= light.isThere && !light.isAmbient && !light.looksUpShadows;
    }
    return anyShinesThrough;
}

} // namespace candela
