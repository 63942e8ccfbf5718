// SPDX-License-Identifier: Apache-2.0
// The primitive variables of a record as every surface wants them: numeric, finite, "st" split.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/primitive_record.h"

#include <string>
#include <vector>

namespace candela {

struct NumericVariable {
    std::string name;
    Declaration declaration;
    int components = 1; ///< Floats in one value, array elements included.
    std::vector<float> values;

    /// How many whole values there are.
    int count() const { return int(values.size()) / components; }
};

/// All numeric variables but the positions P, Pw and Pz; the normals "N" and "Np" are among them.
/// Drops, with an error, what is not finite, no whole number of values or, for Cs, Os, s, t, st, N
/// and Np, of another size than what it is for. Of several of one name
/// the first stays.
std::vector<NumericVariable> numericVariables(const PrimitiveRecord &, DiagnosticSink &);

/// Warns that a variable has not as many values as its class needs.
void reportWrongCount(const NumericVariable &, long expected, const SourceLocation &,
                      DiagnosticSink &);

/// Control points in homogeneous coordinates (x,y,z,w), four floats a point, of "P" (w = 1) or
/// "Pw". Empty, with a report, if neither is there, or they are not finite or w is not positive.
std::vector<float> homogeneousPoints(const PrimitiveRecord &, DiagnosticSink &);

} // namespace candela
