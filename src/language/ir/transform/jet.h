// SPDX-License-Identifier: Apache-2.0
// Derivatives by u and v, forward, of any function: beside each value that reaches a Slope stand
// its derivatives, made by the chain rule from those of the renderer's inputs. Slopes of Slopes
// need derivatives of higher order; all are written in one walk, as Taylor coefficients, so that
// n in a row cost n^3 and not 2^n.
//
// What is known to change with u and v changes as the inputs' derivatives say. The eye and the
// ray's origin stand still, and so do seeds: random numbers have slope 0. Steps (floor, cell noise,
// comparisons) have slope 0, which is right but at the steps. What is not known is taken not to
// change, and reported: light and traced answers, second derivatives of inputs, du and dv.
#pragma once

#include "language/ir/core/ir.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace candela::ir {

/// What an expansion has to say about a place of the text.
struct SlopeNote {
    int line = 0;  ///< 0 = of no line.
    int file = -1; ///< Into Function::files; -1 = that of the shader.
    std::string text;
};

struct SlopeReport {
    /// What was taken not to change though it may; each once.
    std::vector<SlopeNote> held;
    /// Why nothing was written.
    std::optional<SlopeNote> fault;
};

/// No function grows by more values than this.
inline constexpr int mostSlopeValues = 4000;

/// Replaces all Slopes. Faults (then the function stays as it is): derivatives of too high an order
/// or of noise beyond the second, values from a frame, too many values. Variables that override
/// parameters get planes for their derivatives, behind those that the function has.
SlopeReport expandSlopes(Function &, int mostValues = mostSlopeValues);

/// Adds to every output X its derivatives by the directions, as outputs "dXdu" and "dXdv", also of
/// functions that answer a question; not of those that load values from a frame. `of`: of which
/// outputs, if not of all.
SlopeReport addOutputSlopes(Function &, const std::vector<Direction> &,
                            int mostValues = mostSlopeValues,
                            const std::function<bool(const OutputName &)> &of = {});

} // namespace candela::ir
