// SPDX-License-Identifier: Apache-2.0
// The entry points: of each question the function that slices its answer from a text or a plan.
#pragma once

#include "language/ir/questions/plan.h"

namespace candela::ir {

using AnsweredText = Function;
using AnsweredPlan = Plan;
#define QUESTION(name, text, kind, of, reads, writes, products, meaning)                           \
    Function answer##name(const Answered##of &);
#include "language/ir/questions/questions.def"
#undef QUESTION

} // namespace candela::ir
