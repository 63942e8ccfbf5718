// SPDX-License-Identifier: Apache-2.0
#include "apps/verbs.h"

#include "foundation/base/whole_file.h"
#include "world/texture/texture_making.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    std::vector<std::string> files; ///< Pictures, then the texture.
    std::vector<std::string> wrap{"periodic"};
    std::string filter = "box", environment, colorSpace;
    float fieldOfView = 90;
    bool shadow = false, quiet = false;
};

int refuse(const std::string &problem, int status) {
    std::fprintf(stderr, "candela tex: error: %s\n", problem.c_str());
    return status;
}

TextureOrder::Kind kindOf(const Arguments &a) {
    using enum TextureOrder::Kind;
    return a.shadow                     ? Shadow
           : a.environment == "latlong" ? LatLongEnvironment
           : a.environment == "cube"    ? CubeFaceEnvironment
                                        : Texture;
}

TextureOrder orderOf(const Arguments &a) {
    TextureOrder order;
    order.kind = kindOf(a);
    order.pictures.assign(a.files.begin(), a.files.end() - 1);
    order.texture = a.files.back();
    const bool around = !a.environment.empty();
    order.sWrap = around ? "periodic" : a.wrap.front();
    order.tWrap = around ? "clamp" : a.wrap.back();
    order.filter = a.filter;
    order.fieldOfView = a.fieldOfView;
    if (!a.colorSpace.empty()) {
        Parameter space{"colorspace", {StorageClass::Uniform, ValueType::String, 1}, {}, {}};
        space.strings = {a.colorSpace};
        order.parameters.all.push_back(std::move(space));
    }
    return order;
}

int makeFile(const Arguments &a) {
    const std::size_t pictures = kindOf(a) == TextureOrder::Kind::CubeFaceEnvironment ? 6 : 1;
    if (a.files.size() != pictures + 1)
        return refuse(
            "expected " +
                std::string(pictures == 6 ? "six pictures (px nx py ny pz nz)" : "a picture") +
                " and the texture to be made",
            2);
    if (a.shadow && !a.environment.empty())
        return refuse("--shadow and --env exclude each other", 2);
    const TextureOrder order = orderOf(a);
    std::string problem;
    if (!canWriteFile(order.texture, problem) || !makeTexture(order, problem))
        return refuse(problem + "; " + order.texture + " is not made", 1);
    if (!a.quiet)
        std::printf("wrote %s\n", order.texture.c_str());
    return 0;
}

} // namespace

void addTex(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *tex = app.add_subcommand(
        "tex", "Make a texture, an environment or a shadow map from pictures, as MakeTexture and "
               "its like do in RIB: candela tex wood.png wood.tx");
    tex->footer(
        "Textures hold linear light in all sizes that lookups want. Scenes may name pictures "
        "directly, too; ready textures are read faster and say how they repeat.\n"
        "Exit status: 0 all went well, 1 something was wrong and has been reported, 2 the "
        "command line cannot be understood.");
    tex->add_option("files", a.files,
                    "A picture (of --env cube: px nx py ny pz nz), then the texture")
        ->required();
    tex->add_option("--wrap", a.wrap,
                    "periodic, black or clamp: what lies beyond the picture; S,T for either way; "
                    "default periodic")
        ->delimiter(',')
        ->expected(1, 2)
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"periodic", "black", "clamp"}));
    tex->add_option("--filter", a.filter, "By which smaller sizes are made; default box")
        ->check(CLI::IsMember(
            {"box", "triangle", "gaussian", "catmull-rom", "b-spline", "sinc", "mitchell"}));
    tex->add_option("--env", a.environment,
                    "latlong: the picture shows all directions; cube: six pictures do")
        ->check(CLI::IsMember({"latlong", "cube"}));
    tex->add_option("--fov", a.fieldOfView, "Field of view of cube faces in degrees; default 90")
        ->check(CLI::Range(1.0f, 179.0f));
    tex->add_flag("--shadow", a.shadow,
                  "The picture holds depths: one of a display of type zfile or shadow");
    tex->add_option("--color-space", a.colorSpace,
                    "srgb or linear: what the picture's numbers are; default: as it says, and sRGB "
                    "for 8-bit colour")
        ->check(CLI::IsMember({"srgb", "linear"}));
    tex->add_flag("--quiet", a.quiet, "Only messages");
    tex->callback([arguments, &status] { status = makeFile(*arguments); });
}

} // namespace candela
