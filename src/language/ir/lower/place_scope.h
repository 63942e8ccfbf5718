// SPDX-License-Identifier: Apache-2.0
// Where in the source an instruction that has something to say stands.
#pragma once

#include "language/ir/core/builder.h"
#include "language/semantics/typed_ast.h"

namespace candela::ir {

/// While it lives, what is emitted stands at the place: messages at run time name it.
class PlaceScope {
public:
    PlaceScope(Builder &b, const sl::Place &where) : b_(b), line_(b.line()), file_(b.file()) {
        b_.setLine(where.line);
        if (where.file)
            b_.setFile(intern(b_.function().files, where.file->name()));
    }
    ~PlaceScope() {
        b_.setLine(line_);
        b_.setFile(file_);
    }
    PlaceScope(const PlaceScope &) = delete;
    PlaceScope &operator=(const PlaceScope &) = delete;

private:
    Builder &b_;
    int line_, file_;
};

} // namespace candela::ir
