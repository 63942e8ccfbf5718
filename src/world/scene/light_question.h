// SPDX-License-Identifier: Apache-2.0
// Asking light shaders.
#pragma once

#include "foundation/base/planes.h"
#include "language/runtime/shader_abi.h"
#include "world/scene/scene_state.h"

namespace candela {

/// Room for the questions and answers of up to `capacity` points to one light shader code. Inputs
/// that nobody sets are zero.
struct LightBatch {
    explicit LightBatch(int capacity);

    int count = 0;
    bool prints = true; ///< As in ShaderCode::bind().
    /// P is a point of the light's own surface, N and Ng the normals there. Of other lights N and
    /// Ng are those of what they light, Ns.
    bool hasSurface = false;
    /// As in LightQuery.
    std::array<const float *, 3> Ns{}, I{};
    Planes<float> inputs, answers;
    std::vector<const float *> inputTable;
    Planes<std::int32_t> integers;
    std::int32_t *parameterOffset, *objectIndex;
    MovingParameters parameters; ///< At the times of the last question.
    /// From the light to Ps and what arrives; zero where the light doesn't shine.
    std::array<float *, 3> L;
    std::array<float *, colorSamples> Cl;

    float *input(ShaderInput which, int component = 0) const {
        return inputs[int(which) + component];
    }
    /// Lets inputs be read from elsewhere, or (null) from the batch's own planes again.
    void readFrom(ShaderInput which, int components, const float *const *planes);
    /// Asks; `active` as in ShaderArgs. P, Ps and what above says of who asks must be there.
    void ask(const SceneState &, const ShaderCode &, const std::uint16_t *active = nullptr);

private:
    void tellWhoAsks(const ShaderCode &);
    void drawSeeds(const ShaderCode &);
};

/// The shader looks at what is lit, beyond where that is.
bool readsWhatIsLit(const ShaderCode &, bool hasSurface);

inline constexpr int lightBatchSize = 512;

/// P of lights without a surface: the origin of "shader" space, at the lane's time.
void placePointLight(LightBatch &, int lane, const SceneLight &, const Shutter &);

} // namespace candela
