// SPDX-License-Identifier: Apache-2.0
#include "inputs.h"

#include "mutation.h"
#include "token_stream.h"

namespace candela::fuzz {

std::string InputName::file() const {
    return std::to_string(seed) + (kind == InputKind::MutatedShader ? "-mutated.sl" : "-tokens.sl");
}

std::string makeInput(InputName name, const Corpus &corpus) {
    Chance chance(name.seed * 2 + std::uint64_t(name.kind));
    if (name.kind == InputKind::TokenStream)
        return randomStream(corpus, chance);
    Words words = chance.pick(corpus.texts);
    constexpr std::size_t counts[] = {1, 1, 1, 2, 3, 6};
    for (std::size_t n = chance.pick(counts); n > 0; --n)
        mutate(words, corpus, chance);
    return textOf(words);
}

} // namespace candela::fuzz
