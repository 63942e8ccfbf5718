// SPDX-License-Identifier: Apache-2.0
// What depends on what: the binding time of every value, and where it is made.
#pragma once

#include "language/ir/core/ir.h"

#include <vector>

namespace candela::ir {

/// Dependence by data and by control. A value made in a branch does not depend on the branch's
/// condition (it may be computed earlier, whatever the condition will be); what leaves the branch
/// does. Loops stay behind their conditions, since only then do they surely end; and so do
/// services, since nobody may be asked in vain.
struct Dependence {
    struct Definition {
        const Instruction *instruction = nullptr; ///< Null for arguments of regions.
        int result = 0;
    };
    std::vector<BindingTime> bindingTime;      ///< By ValueId.
    std::vector<BindingTime> arrayBindingTime; ///< By array: of all its loads and stores.
    std::vector<Definition> definition;        ///< By ValueId.
    /// By request: the instruction that makes it; null if it is gone.
    std::vector<const Instruction *> request;
    bool staticRequests = true;
    int notStaticLine = 0;

    /// Whether light reaches the value.
    bool responds(ValueId v) const { return bindingTime[v] == BindingTime::Response; }
};

/// The function must outlive the result.
Dependence analyzeDependence(const Function &);

} // namespace candela::ir
