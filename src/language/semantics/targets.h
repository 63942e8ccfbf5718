// SPDX-License-Identifier: Apache-2.0
// What may be assigned to, and what to it.
#pragma once

#include "language/semantics/surroundings.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// All variables may be assigned, as files of thirty years do; the author is told where the
/// language says otherwise.
void hintIfReadOnly(const Symbol &, const Place &, const Surroundings &);
/// The variable that an assignment to the target changes.
Symbol &symbolOf(const Expr &target);
/// Whether the target may hold values of that detail; reported if not. Strings without a stated
/// detail take that of what they are given.
bool detailFits(const Expr &target, Detail value, const Place &, Reporter &);

} // namespace candela::sl
