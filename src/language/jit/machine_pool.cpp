// SPDX-License-Identifier: Apache-2.0
#include "language/jit/machine_pool.h"

#include <llvm/Support/CommandLine.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/TargetParser/Host.h>

#include <map>
#include <mutex>
#include <vector>

namespace candela {

namespace {

struct MachinePool {
    std::mutex mutex;
    std::map<std::string, std::vector<std::unique_ptr<llvm::TargetMachine>>> idle;
};

/// Lives as long as the process: threads may compile to its end.
MachinePool &pool() {
    static auto *const machines = new MachinePool;
    return *machines;
}

std::unique_ptr<llvm::TargetMachine> createMachine(const CodeTarget &target) {
    llvm::TargetOptions options;
    options.AllowFPOpFusion = llvm::FPOpFusion::Strict;
    return std::unique_ptr<llvm::TargetMachine>(nativeTarget()->createTargetMachine(
        llvm::sys::getProcessTriple(), target.cpu, target.features, options, llvm::Reloc::PIC_,
        llvm::CodeModel::Small, llvm::CodeGenOptLevel::Default, true));
}

/// What LLVM searches through without need. Less of it changes the order of instructions, and no
/// result.
void limitSearches() {
    struct Limit {
        const char *option;
        unsigned most;
    };
    constexpr Limit limits[] = {
        // Stores and loads in a row, of which its scheduler looks at all pairs, and for each at all
        // that it has found of them: of 1,000, as it would, that takes seconds.
        {"dag-maps-huge-region", 128},
        // Loads that stores wait for together, each of which is looked through again for each
        // store: of 2,048, as it would, likewise.
        {"combiner-tokenfactor-inline-limit", 64},
    };
    auto &options = llvm::cl::getRegisteredOptions();
    for (const Limit &limit : limits)
        if (const auto found = options.find(limit.option); found != options.end())
            static_cast<llvm::cl::opt<unsigned> *>(found->second)->setValue(limit.most);
}

} // namespace

const llvm::Target *nativeTarget() {
    static const llvm::Target *const target = [] {
        limitSearches();
        llvm::InitializeNativeTarget();
        llvm::InitializeNativeTargetAsmPrinter();
        std::string error;
        return llvm::TargetRegistry::lookupTarget(llvm::sys::getProcessTriple(), error);
    }();
    return target;
}

void MachineReturn::operator()(llvm::TargetMachine *machine) const {
    std::lock_guard lock(pool().mutex);
    pool().idle[key].emplace_back(machine);
}

LentMachine lendMachine(const CodeTarget &target) {
    MachineReturn back{target.cpu + " " + target.features};
    {
        std::lock_guard lock(pool().mutex);
        auto &idle = pool().idle[back.key];
        if (!idle.empty()) {
            LentMachine lent(idle.back().release(), back);
            idle.pop_back();
            return lent;
        }
    }
    return LentMachine(createMachine(target).release(), back);
}

} // namespace candela
