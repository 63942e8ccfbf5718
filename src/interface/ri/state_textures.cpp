// SPDX-License-Identifier: Apache-2.0
// The requests that make textures: done where they stand in the stream, so that frames behind them
// find what they have made, and they what frames before them have.
#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

static std::string wrapMode(RequestDiagnostics &diagnostics, const SourceLocation &where,
                            const std::string &request, const std::string &mode) {
    constexpr const char *known[] = {"black", "clamp", "periodic"};
    if (std::ranges::find(known, mode) != std::end(known))
        return mode;
    diagnostics.error(where, request.c_str(),
                      "there is no wrap mode \"" + mode +
                          "\": expected \"black\", \"clamp\" or \"periodic\"; taking \"black\"");
    return "black";
}

void StateHandlers::order(const SourceLocation &where, TextureOrder order,
                          const TokenList &tokens) {
    order.parameters = parameters_.ofRequest(where, tokens, order.request.c_str());
    for (std::string *mode : {&order.sWrap, &order.tWrap})
        *mode = wrapMode(diagnostics_, where, order.request, *mode);
    if (settings_.makeTexture)
        settings_.makeTexture(order, state_.options);
}

void StateHandlers::makeTexture(const SourceLocation &where, const std::string &picture,
                                const std::string &texture, const std::string &sWrap,
                                const std::string &tWrap, const std::string &filter, float, float,
                                const TokenList &tokens) {
    using enum TextureOrder::Kind;
    order(where, {Texture, "MakeTexture", {picture}, texture, sWrap, tWrap, filter, 90, {}},
          tokens);
}

void StateHandlers::makeBump(const SourceLocation &where, const std::string &picture,
                             const std::string &texture, const std::string &sWrap,
                             const std::string &tWrap, const std::string &filter, float, float,
                             const TokenList &tokens) {
    using enum TextureOrder::Kind;
    order(where, {Bump, "MakeBump", {picture}, texture, sWrap, tWrap, filter, 90, {}}, tokens);
}

void StateHandlers::makeLatLongEnvironment(const SourceLocation &where, const std::string &picture,
                                           const std::string &texture, const std::string &filter,
                                           float, float, const TokenList &tokens) {
    using enum TextureOrder::Kind;
    order(where,
          {LatLongEnvironment,
           "MakeLatLongEnvironment",
           {picture},
           texture,
           "periodic",
           "clamp",
           filter,
           90,
           {}},
          tokens);
}

void StateHandlers::makeCubeFaceEnvironment(const SourceLocation &where, const std::string &px,
                                            const std::string &nx, const std::string &py,
                                            const std::string &ny, const std::string &pz,
                                            const std::string &nz, const std::string &texture,
                                            float fieldOfView, const std::string &filter, float,
                                            float, const TokenList &tokens) {
    using enum TextureOrder::Kind;
    if (!(fieldOfView > 0 && fieldOfView < 180)) {
        diagnostics_.error(where, "MakeCubeFaceEnvironment",
                           "expected a field of view between 0 and 180 degrees; taking 90");
        fieldOfView = 90;
    }
    order(where,
          {CubeFaceEnvironment,
           "MakeCubeFaceEnvironment",
           {px, nx, py, ny, pz, nz},
           texture,
           "periodic",
           "clamp",
           filter,
           fieldOfView,
           {}},
          tokens);
}

void StateHandlers::makeShadow(const SourceLocation &where, const std::string &picture,
                               const std::string &texture, const TokenList &tokens) {
    using enum TextureOrder::Kind;
    order(where, {Shadow, "MakeShadow", {picture}, texture, "black", "black", "box", 90, {}},
          tokens);
}

} // namespace candela
