// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_spaces.h"

#include <algorithm>

namespace candela {

namespace {

void storeMatrices(const Matrix4 &currentFromSpace, float *to) {
    Matrix4 spaceFromCurrent = inverse(currentFromSpace).value_or(Matrix4{});
    std::ranges::copy(currentFromSpace.m, to);
    std::ranges::copy(spaceFromCurrent.m, to + 16);
}

/// The line where the text asks for a coordinate system first; 0 if that is not known.
int lineOfSpace(const ir::Region &region, int space) {
    for (const ir::Instruction &i : region.body) {
        if ((i.op == ir::Op::Space || i.op == ir::Op::SpaceInverse) && i.immediate == space)
            return i.line;
        for (const ir::Region &inner : i.regions)
            if (const int line = lineOfSpace(inner, space))
                return line;
    }
    return 0;
}

} // namespace

void ShaderSpaces::bind(const ir::Function &function, const std::string &shader,
                        const std::map<std::string, Matrix4> &systems,
                        DiagnosticSink &diagnostics) {
    const std::vector<std::string> &names = function.spaces;
    matrices_.resize(names.size());
    pointers_.clear();
    for (std::size_t i = 0; i < names.size(); ++i) {
        auto found = systems.find(names[i]);
        if (found == systems.end())
            diagnostics.warning({}, "shader \"" + shader + "\", line " +
                                        std::to_string(lineOfSpace(function.body, int(i))) +
                                        ": asks for the coordinate system \"" + names[i] +
                                        "\", which the scene does not define: taking \"current\"");
        storeMatrices(found == systems.end() ? Matrix4{} : found->second, matrices_[i].data());
        pointers_.push_back(matrices_[i].data());
    }
}

} // namespace candela
