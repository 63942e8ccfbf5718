// SPDX-License-Identifier: Apache-2.0
#include "world/shading/filter_code.h"

#include "language/ir/filter/pixel_loops.h"
#include "language/ir/questions/questions.h"

#include <algorithm>

namespace candela {

std::shared_ptr<const FilterCode>
FilterCode::compile(ir::Function whole, std::shared_ptr<Jit> jit,
                    std::shared_ptr<const ShaderMessages> messages,
                    std::shared_ptr<const ShaderAnswers> answers, DiagnosticSink &diagnostics) {
    std::shared_ptr<FilterCode> filter(new FilterCode);
    filter->name_ = whole.name;
    filter->driver_ = ir::extractPixelLoops(ir::slice(whole, ir::Question::Filter));
    std::vector<const ir::Function *> functions{&filter->driver_};
    for (const ir::PixelLoop &loop : filter->driver_.pixelLoops)
        functions.push_back(loop.body.get());
    std::vector<ShaderFunction> codes = jit->compile(functions, diagnostics);
    if (std::ranges::count(codes, nullptr) > 0)
        return nullptr;
    filter->code_ = codes[0];
    filter->loops_.assign(codes.begin() + 1, codes.end());
    filter->jit_ = std::move(jit);
    filter->messages_ = std::move(messages);
    filter->answers_ = std::move(answers);
    return filter;
}

} // namespace candela
