// SPDX-License-Identifier: Apache-2.0
#include "light/frame/light_warnings.h"

namespace candela {

void warnOfLights(const Scene &scene, DiagnosticSink &diagnostics) {
    if (scene.bound().empty()) // Nothing to shine on: nothing to say of lights.
        return;
    const Lights lights = scene.lights();
    for (int index = 0; index < lights.count(); ++index) {
        const LightFacts light = lights.facts(index);
        if (light.lacksShapes)
            diagnostics.warning(light.where, light.title +
                                                 " gives no light: no primitive stands between its "
                                                 "AreaLightSource and the end of its block");
        else if (light.isThere && !light.isEverOn && !light.isTurnedOff)
            diagnostics.warning(light.where,
                                light.title +
                                    " shines on nothing, unless on its own shapes: a light is on "
                                    "to the end of the block that it stands in; Illuminate turns "
                                    "it on elsewhere");
    }
}

bool lightsCastNoShadows(const Scene &scene) {
    const Lights lights = scene.lights();
    bool anyLamp = false;
    for (int index = 0; index < lights.count(); ++index) {
        const LightFacts light = lights.facts(index);
        if (light.castsShadow)
            return false;
        anyLamp |= light.isThere && !light.isAmbient;
    }
    return anyLamp;
}

} // namespace candela
