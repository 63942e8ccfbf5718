// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/option_checks.h"

#include <limits>
#include <map>

namespace candela {

namespace {

struct GivenOption {
    RequestDiagnostics &diagnostics;
    const SourceLocation &where;
    const Parameter &parameter;

    /// Of the first value.
    std::string text() const { return parameter.strings.empty() ? "" : parameter.strings.front(); }
    bool wrong(const std::string &message) const {
        diagnostics.error(where, "Option", message);
        return false;
    }
};

bool integrator(const GivenOption &given) {
    const std::string name = given.text();
    if (name != "path" && name != "classic" && name != "bidir" && name != "vcm" &&
        name != "radiosity")
        given.wrong(
            "there is no integrator \"" + name +
            "\": the known ones are \"path\", \"bidir\", \"vcm\", \"radiosity\" and \"classic\"; "
            "taking \"path\"");
    return true;
}

bool highlights(const GivenOption &given) {
    const std::string name = given.text();
    return name == "production" || name == "ri" ||
           given.wrong("there are no highlights \"" + name +
                       "\": the known ones are \"production\" (exponent 8/roughness) and \"ri\" "
                       "(1/roughness)");
}

bool loopTurns(const GivenOption &given) {
    const float turns = given.parameter.floats.empty() ? 0 : given.parameter.floats.front();
    return (turns >= 1 && turns <= 1 << 30) ||
           given.wrong("\"shading\" \"loopturns\" is how many turns a shader's loop may take at a "
                       "point, a number from 1 to 1073741824");
}

bool maxDepth(const GivenOption &given) {
    const float depth = given.parameter.floats.empty() ? 0 : given.parameter.floats.front();
    return (depth >= 0 && depth <= 1 << 20) ||
           given.wrong("\"trace\" \"maxdepth\" is how often light may be scattered on its way to "
                       "the eye, a number from 0 (emission alone) to 1048576");
}

bool isWithin(const GivenOption &given, float least, float most) {
    const float number = given.parameter.floats.empty() ? -1 : given.parameter.floats.front();
    return number >= least && number <= most;
}

bool lightPaths(const GivenOption &given) {
    return isWithin(given, 0, 1e4f) ||
           given.wrong("\"bidir\" \"lightpaths\" is how many paths begin on lights for each sample "
                       "of a pixel, a number from 0 to 10000");
}

bool connections(const GivenOption &given) {
    return isWithin(given, 0, 64) ||
           given.wrong(
               "\"bidir\" \"connections\" is with how many points on paths from lights each "
               "point that the camera finds is connected, a number from 0 to 64");
}

bool trust(const GivenOption &given) {
    return isWithin(given, 1e-6f, 1e6f) ||
           given.wrong("\"bidir\" \"trust\" is what paths from lights count in weights besides "
                       "their number, a number from 0.000001 to 1000000");
}

bool finalPass(const GivenOption &given) {
    const std::string name = given.text();
    return name == "fe" || name == "fe+direct" || name == "gather" ||
           given.wrong("there is no final pass \"" + name +
                       "\": the known ones are \"fe\", \"fe+direct\" and \"gather\"");
}

bool epsilon(const GivenOption &given) {
    return isWithin(given, 1e-9f, 1) ||
           given.wrong("\"radiosity\" \"epsilon\" is what an exchange of light between two "
                       "elements may get wrong, in shares of all light, a number from 1e-9 to 1");
}

bool contrast(const GivenOption &given) {
    return isWithin(given, 0, 1e9f) ||
           given.wrong(
               "\"radiosity\" \"contrast\" is how much irradiance elements may get wrong, in "
               "shares of what there is on average, before pixels ask for it themselves, a "
               "number from 0 to 1e9");
}

bool leastElement(const GivenOption &given) {
    return isWithin(given, 1e-9f, 1) ||
           given.wrong("\"radiosity\" \"leastelement\" is the smallest element, in shares of all "
                       "surfaces, a number from 1e-9 to 1");
}

bool order(const GivenOption &given) {
    return isWithin(given, 1, 3) ||
           given.wrong("\"radiosity\" \"order\" is 1 (constant elements), 2 (bilinear ones) or 3 "
                       "(biquadratic ones)");
}

bool directSamples(const GivenOption &given) {
    return isWithin(given, 1, 4096) ||
           given.wrong("\"radiosity\" \"samples\" is how many samples of light sources each node "
                       "of an element takes, a number from 1 to 4096");
}

bool mergingRadius(const GivenOption &given) {
    return isWithin(given, std::numeric_limits<float>::min(), std::numeric_limits<float>::max()) ||
           given.wrong("\"vcm\" \"radius\" is how far points that are merged lie apart at first, "
                       "in metres, a number above 0");
}

bool mergingTrust(const GivenOption &given) {
    return isWithin(given, 1e-6f, 1e6f) ||
           given.wrong("\"vcm\" \"trust\" is what merging counts in weights besides its number, a "
                       "number from 0.000001 to 1000000");
}

bool textureMemory(const GivenOption &given) {
    return isWithin(given, 0, float(1 << 30)) ||
           given.wrong("\"limits\" \"texturememory\" is how many kibibytes of textures are kept, "
                       "a number from 0 (as many as usual) to 1073741824");
}

} // namespace

bool checkOption(RequestDiagnostics &diagnostics, const SourceLocation &where,
                 const std::string &category, const Parameter &parameter) {
    static const std::map<std::string, bool (*)(const GivenOption &), std::less<>> checks = {
        {"bidir:connections", connections},
        {"bidir:lightpaths", lightPaths},
        {"bidir:trust", trust},
        {"limits:texturememory", textureMemory},
        {"radiosity:contrast", contrast},
        {"radiosity:epsilon", epsilon},
        {"radiosity:finalpass", finalPass},
        {"radiosity:leastelement", leastElement},
        {"radiosity:order", order},
        {"radiosity:samples", directSamples},
        {"render:integrator", integrator},
        {"shading:highlights", highlights},
        {"shading:loopturns", loopTurns},
        {"trace:maxdepth", maxDepth},
        {"vcm:radius", mergingRadius},
        {"vcm:trust", mergingTrust},
    };
    const auto check = checks.find(category + ":" + parameter.name);
    return check == checks.end() || check->second({diagnostics, where, parameter});
}

} // namespace candela
