// SPDX-License-Identifier: Apache-2.0
// How much the calls of functions add to a text: each writes the function's body once more.
#pragma once

#include "language/semantics/typed_ast.h"

#include <cstddef>
#include <optional>
#include <set>

namespace candela::ir {

struct Lowering;

struct Inlining {
    std::set<const sl::Function *> seen; ///< Functions whose bodies are in the text.
    std::size_t copied = 0;              ///< Instructions of bodies that were in the text before.
    std::size_t visited = 0; ///< Nodes of such bodies' trees: some give no new instructions.
    /// What the text's budget had left where the body began that is being written once more.
    std::optional<std::size_t> copyStart;
    bool refused = false; ///< The text is too large, and that has been said.
};

/// Whether the text is larger than it may be: then what is left of it needs no lowering. The first
/// time it is reported, with the functions whose bodies are being written. To be asked at each node
/// of the tree.
bool isTooLarge(Lowering &, const sl::Place &);

/// While it lives, the body of a function is being written.
class BodyScope {
public:
    BodyScope(Lowering &, const sl::Function &);
    ~BodyScope();
    BodyScope(const BodyScope &) = delete;
    BodyScope &operator=(const BodyScope &) = delete;

private:
    Lowering &lowering_;
    bool outermost_; ///< Of the bodies that were in the text before.
};

} // namespace candela::ir
