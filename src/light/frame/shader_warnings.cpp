// SPDX-License-Identifier: Apache-2.0
#include "light/frame/shader_warnings.h"

#include "light/path/gathered_light.h"

namespace candela {

void ShaderWarnings::look(const Scene &scene) {
    for (int number = 1; number < scene.mediaCount(); ++number) {
        const ShaderCode &code = *scene.medium(number).code;
        const int line = code.volumeFacts().notAffineLine; // 0 = none in particular.
        if (!code.volumeFacts().affine)
            once("volume shader \"" + code.name() + "\"" +
                 (line > 0 ? ", line " + std::to_string(line) : "") +
                 ": what it makes of the light that it is given does not grow in proportion to "
                 "it, channel by channel; it is taken for the straight line through what it makes "
                 "of black and of 1");
    }
    if (scene.isClassic())
        return;
    for (int index = 0; index < scene.codeCount(); ++index) {
        const ShaderCode &code = scene.code(index);
        const ir::SurfaceFacts &facts = code.facts();
        auto at = [&](int line) {
            return "shader \"" + code.name() + "\", line " + std::to_string(line) + ": ";
        };
        if (!facts.affine)
            once(at(facts.notAffineLine) +
                 "what it sends does not grow in proportion to the light, so it is given " +
                 std::to_string(GatheredLight::rounds) +
                 " samples of all light at once; its look depends on that number");
        if (facts.printsLightLine > 0)
            once(at(facts.printsLightLine) +
                 "this printf() speaks of light, which paths bring one direction at a time: it "
                 "says what it would say in the dark; --integrator classic prints it lit");
        if (!facts.staticRequests)
            once(at(facts.notStaticLine) +
                 "this light request stands in a loop of unknown length or depends on another's "
                 "answer, so the shader is run whole for every sample; the picture is right, but "
                 "takes longer");
    }
}

void ShaderWarnings::once(const std::string &message) {
    if (said_.insert(message).second)
        diagnostics_.warning({}, message);
}

} // namespace candela
