// SPDX-License-Identifier: Apache-2.0
// How calls of ri.h are defined, in both forms. Private to the room.
#pragma once

#include "binding/c/arguments.h"
#include "binding/c/context.h"

#include <cstdarg>
#include <functional>
#include <vector>

namespace candela::c {

/// Calls body(context), unless there is none, which is reported. Nothing is thrown into C.
void perform(const char *call, const std::function<void(Context &)> &body);

/// The tokens and values of a call, up to RI_NULL.
class Gathered {
public:
    explicit Gathered(std::va_list);
    RtInt count() const { return RtInt(tokens_.size()); }
    RtToken *tokens() { return tokens_.data(); }
    RtPointer *values() { return values_.data(); }

private:
    std::vector<RtToken> tokens_;
    std::vector<RtPointer> values_;
};

} // namespace candela::c

#define RI_TAKEN_APART(...) __VA_ARGS__
#define RI_GATHER(last)                                                                            \
    std::va_list arguments;                                                                        \
    va_start(arguments, last);                                                                     \
    Gathered given(arguments);                                                                     \
    va_end(arguments)

/// RI_PLAIN(Name, (parameters), call of the sink): `ri` is the context.
#define RI_PLAIN(Name, PARAMETERS, ...)                                                            \
    void Ri##Name PARAMETERS {                                                                     \
        perform("Ri" #Name, [&](Context &ri) { ri.sink().__VA_ARGS__; });                          \
    }
/// RI_LISTED(Name, last parameter, (parameters), (their names), call of the sink): with a list,
/// `n`, `tokens` and `values`.
#define RI_LISTED(Name, last, PARAMETERS, NAMES, ...)                                              \
    void Ri##Name(RI_TAKEN_APART PARAMETERS, ...) {                                                \
        RI_GATHER(last);                                                                           \
        Ri##Name##V(RI_TAKEN_APART NAMES, given.count(), given.tokens(), given.values());          \
    }                                                                                              \
    void Ri##Name##V(RI_TAKEN_APART PARAMETERS, RtInt n, RtToken tokens[], RtPointer values[]) {   \
        perform("Ri" #Name, [&](Context &ri) { ri.sink().__VA_ARGS__; });                          \
    }
