// SPDX-License-Identifier: Apache-2.0
// The campaign's inputs, made of their number and the corpus (and of what the compiler accepts).
#pragma once

#include "corpus.h"

#include <cstdint>
#include <functional>
#include <string>

namespace candela::fuzz {

enum class InputKind : std::uint8_t { MutatedShader, TokenStream };

struct InputName {
    InputKind kind = InputKind::MutatedShader;
    std::uint64_t seed = 0;

    /// "17-mutated.sl", "17-tokens.sl".
    std::string file() const;
};

/// Whether a text compiles.
using Accepts = std::function<bool(const std::string &text)>;

/// Two mutated shaders in three have gone through texts that compile alone, so that they may have
/// been changed far and still mean something; the last change of all may break them.
std::string makeInput(InputName, const Corpus &, const Accepts &);

} // namespace candela::fuzz
