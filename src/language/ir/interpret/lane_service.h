// SPDX-License-Identifier: Apache-2.0
// A service as one lane asks it.
#pragma once

#include "language/ir/core/ir.h"

#include <string>
#include <vector>

namespace candela::ir {

class LaneService {
public:
    /// `i` is a Query or a Command of the function.
    LaneService(const Function &, const Instruction &i);

    /// The next operand; of strings, the integer is an index into Function::strings.
    void add(Type, ServiceCell);
    /// The results.
    std::vector<float> ask(const ShaderArgs &, int lane) const;

private:
    const Function &function_;
    const Instruction &instruction_;
    std::string types_, strings_;
    std::vector<ServiceCell> operands_;
};

} // namespace candela::ir
