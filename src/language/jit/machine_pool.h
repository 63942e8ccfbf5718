// SPDX-License-Identifier: Apache-2.0
// LLVM's target machines, which cost milliseconds to make: lent out, one thread at a time.
#pragma once

#include "language/jit/code_target.h"

#include <llvm/MC/TargetRegistry.h>
#include <llvm/Target/TargetMachine.h>

#include <memory>

namespace candela {

/// The target that code of this process is for.
const llvm::Target *nativeTarget();

struct MachineReturn {
    std::string key;
    void operator()(llvm::TargetMachine *) const;
};
/// Goes back to the pool at its end.
using LentMachine = std::unique_ptr<llvm::TargetMachine, MachineReturn>;
LentMachine lendMachine(const CodeTarget &);

} // namespace candela
