// SPDX-License-Identifier: Apache-2.0
#include "inputs.h"

#include "mutation.h"
#include "token_stream.h"

namespace candela::fuzz {

std::string InputName::file() const {
    return std::to_string(seed) + (kind == InputKind::MutatedShader ? "-mutated.sl" : "-tokens.sl");
}

namespace {

constexpr std::size_t mostBytes = 200'000;

/// Mutations of which those are undone that leave no shader.
void mutateAccepted(Words &words, std::size_t count, const Corpus &corpus, Chance &chance,
                    const Accepts &accepts) {
    for (std::size_t n = 0; n < count; ++n) {
        Words changed = words;
        mutate(changed, corpus, chance);
        const std::string text = textOf(changed);
        if (text.size() < mostBytes && accepts(text))
            words = std::move(changed);
    }
}

} // namespace

std::string makeInput(InputName name, const Corpus &corpus, const Accepts &accepts) {
    Chance chance(name.seed * 2 + std::uint64_t(name.kind));
    if (name.kind == InputKind::TokenStream)
        return randomStream(corpus, chance);
    Words words = chance.pick(corpus.texts);
    constexpr std::size_t acceptedCounts[] = {0, 0, 3, 6, 12, 25}, lastCounts[] = {0, 0, 1, 1, 2};
    const std::size_t accepted = chance.pick(acceptedCounts);
    mutateAccepted(words, accepted, corpus, chance, accepts);
    for (std::size_t n = chance.pick(lastCounts) + (accepted == 0); n > 0; --n)
        mutate(words, corpus, chance);
    return textOf(words).substr(0, mostBytes);
}

} // namespace candela::fuzz
