// SPDX-License-Identifier: Apache-2.0
// Ways to change a shader's text so that much of it keeps its meaning.
#pragma once

#include "chance.h"
#include "corpus.h"
#include "words.h"

namespace candela::fuzz {

/// Changes the text in one way: numbers, words, lines, parts in brackets, statements, nesting,
/// directives or bytes. Pieces may come from any text of the corpus.
void mutate(Words &, const Corpus &, Chance &);

} // namespace candela::fuzz
