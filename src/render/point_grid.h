// SPDX-License-Identifier: Apache-2.0
// The points that `candela run` asks a shader about, a batch at a time.
#pragma once

#include "foundation/base/planes.h"
#include "world/shading/shader_code.h"

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace candela {

class PointGrid {
public:
    static constexpr int batchSize = 512;

    PointGrid(int width, int height, const QuestionCode &);

    /// The points from number `first` on, row by row, as runShader() describes them.
    void place(sl::ShaderKind, std::size_t first, int count);
    void ask(const QuestionCode &, const ShaderInstance &, int count);
    /// A plane of the answers, in the order of the question's outputs.
    const float *output(int plane) const { return outputs_[plane]; }

private:
    void set(ShaderInput, int lane, std::initializer_list<float> values);
    void fill(ShaderInput, int count, std::initializer_list<float> values);
    void fillWhatIsTheSame(int count);

    int width_, height_;
    Planes<float> inputs_, outputs_;
    Planes<std::int32_t> integers_;
    Planes<float> light_; ///< L and Cl of the light.
    std::vector<const float *> inputTable_, lightTable_;
    std::vector<float *> outputTable_;
};

} // namespace candela
