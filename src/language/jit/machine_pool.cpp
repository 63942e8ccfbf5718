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

/// LLVM's scheduler looks at all pairs of so many stores and loads in a row, and for each at all
/// that it has found of them; of 1,000, as it would, that takes seconds. Beyond so many it keeps
/// the order of a part of them, which changes no result.
void limitPairsOfScheduler() {
    constexpr unsigned mostInARow = 128;
    auto &options = llvm::cl::getRegisteredOptions();
    if (const auto found = options.find("dag-maps-huge-region"); found != options.end())
        static_cast<llvm::cl::opt<unsigned> *>(found->second)->setValue(mostInARow);
}

} // namespace

const llvm::Target *nativeTarget() {
    static const llvm::Target *const target = [] {
        limitPairsOfScheduler();
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
