// SPDX-License-Identifier: Apache-2.0
// The campaign's inputs, made of their number and the corpus alone.
#pragma once

#include "corpus.h"

#include <cstdint>
#include <string>

namespace candela::fuzz {

enum class InputKind : std::uint8_t { MutatedShader, TokenStream };

struct InputName {
    InputKind kind = InputKind::MutatedShader;
    std::uint64_t seed = 0;

    /// "17-mutated.sl", "17-tokens.sl".
    std::string file() const;
};

std::string makeInput(InputName, const Corpus &);

} // namespace candela::fuzz
