// SPDX-License-Identifier: Apache-2.0
// Random streams of the language's words.
#pragma once

#include "chance.h"
#include "corpus.h"
#include "words.h"

namespace candela::fuzz {

/// A word of any class; now and then a whole line with #.
Word randomWord(Chance &);

/// So many words, whatever they mean together.
Words randomWords(std::size_t count, Chance &);

/// Words of which most follow their predecessor as one does in the corpus.
Words plausibleWords(std::size_t count, const Corpus &, Chance &);

/// A whole input: bare words, or words as a shader's body, a function's, or its parameters.
std::string randomStream(const Corpus &, Chance &);

} // namespace candela::fuzz
