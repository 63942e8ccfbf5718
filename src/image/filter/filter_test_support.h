// SPDX-License-Identifier: Apache-2.0
// For tests: a filter's text run as compiled code, and by the interpreter, turn by turn.
#pragma once

#include "image/filter/bound_maps.h"
#include "image/filter/filter_run.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"
#include "language/semantics/front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace candela {

/// The whole text, its parameters at their defaults; nothing, with messages, if it has errors.
inline std::optional<ir::Function> filterText(const std::string &source,
                                              DiagnosticSink &diagnostics) {
    const auto front = sl::analyzeSource({"test.sl", source}, {}, diagnostics);
    const auto lowered = front ? ir::lower(*front->shaders[0], {}, {}, diagnostics) : std::nullopt;
    if (!lowered)
        return {};
    std::vector<float> block(lowered->whole.parameters.size());
    for (const ir::ShaderParameter &parameter : lowered->parameters)
        if (parameter.firstSlot >= 0)
            std::ranges::copy(parameter.defaults, block.begin() + parameter.firstSlot);
    return ir::foldAll(lowered->whole, block);
}

/// A picture of which no two pixels are alike, in (0, 1).
inline OwnedImage testPicture(int width, int height, int channels = 3) {
    OwnedImage image(width, height, channels);
    for (int c = 0; c < channels; ++c)
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const double t = 12.9898 * x + 78.233 * y + 37.719 * c + 1;
                image.row(c, y)[x] = float(std::abs(std::sin(t)) * .9 + .05);
            }
    return image;
}

inline ImageMaps testMaps(int width, int height) {
    ImageMaps maps;
    maps.set("Ci", testPicture(width, height));
    OwnedImage depth = testPicture(width, height, 1);
    maps.set("Z", std::move(depth));
    return maps;
}

struct CompiledFilter {
    explicit CompiledFilter(const ir::Function &whole, int width = laneBlock) {
        JitOptions options;
        options.width = width;
        code = FilterCode::compile(
            whole, std::make_shared<Jit>(options, diagnostics),
            std::make_shared<const ShaderMessages>(diagnostics),
            std::make_shared<const ShaderAnswers>(std::vector<std::string>{}, diagnostics),
            diagnostics);
        EXPECT_TRUE(code) << diagnostics.text();
    }
    void run(ImageMaps &maps) {
        const FilterListeners listeners{diagnostics, {}, {}};
        FilterWatch watch(listeners);
        watch.begin(code->name(), 0);
        runFilter(*code, maps, watch, diagnostics);
    }

    DiagnosticList diagnostics;
    std::shared_ptr<const FilterCode> code;
};

/// By the interpreter, all loops as the text has them.
inline void interpretFilter(const ir::Function &whole, ImageMaps &maps,
                            DiagnosticSink &diagnostics) {
    const ir::Function filter = ir::slice(whole, ir::Question::Filter);
    const OwnedImage &given = *maps.find("Ci");
    const float facts[] = {float(given.width()), float(given.height())};
    BoundMaps bound(filter, maps, diagnostics);
    ASSERT_TRUE(bound.bind());
    ShaderServices services;
    services.context = &bound;
    services[Service::setsize] = [](void *maps, const ServiceCall &call) {
        static_cast<BoundMaps *>(maps)->resize(call.site->texts[0], call.operand(0, 0).number,
                                               call.operand(1, 0).number, *call.site);
    };
    ShaderArgs args;
    args.count = 1;
    args.maps = bound.views();
    args.captured = facts;
    args.services = &services;
    ir::interpret(filter, args);
    bound.handOver();
}

} // namespace candela
