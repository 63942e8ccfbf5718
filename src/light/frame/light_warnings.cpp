// SPDX-License-Identifier: Apache-2.0
#include "light/frame/light_warnings.h"

namespace candela {

void LightWarnings::look(const Scene &scene) {
    if (scene.bound().empty()) // Nothing to shine on: nothing to say of lights.
        return;
    const Lights lights = scene.lights();
    bool anyShadow = false, anyLamp = false;
    for (int index = 0; index < lights.count(); ++index) {
        const LightFacts light = lights.facts(index);
        anyLamp |= light.isThere && !light.isAmbient;
        anyShadow |= light.castsShadow;
        if (light.lacksShapes)
            diagnostics_.warning(light.where,
                                 light.title + " gives no light: no primitive stands between its "
                                               "AreaLightSource and the end of its block");
        else if (light.isThere && !light.isEverOn)
            diagnostics_.warning(
                light.where, light.title +
                                 " shines on nothing, unless on its own shapes: a light is on "
                                 "to the end of the block that it stands in; Illuminate turns it "
                                 "on elsewhere");
    }
    if (!scene.isClassic() || !anyLamp || anyShadow || hasSpokenOfShadows_)
        return;
    hasSpokenOfShadows_ = true;
    Diagnostic note;
    note.severity = Severity::Note;
    note.message = "lights cast no shadows under the integrator \"classic\", unless Attribute "
                   "\"light\" \"string shadows\" \"on\" stands before them or their shaders look "
                   "them up; --integrator path casts them all";
    diagnostics_.report(note);
}

} // namespace candela
