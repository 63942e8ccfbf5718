// SPDX-License-Identifier: Apache-2.0
#include "language/jit/compiler.h"

#include "foundation/base/instruction_set.h"
#include "language/jit/function_generator.h"

#include <llvm/IR/LegacyPassManager.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/Verifier.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Target/TargetMachine.h>
#include <llvm/TargetParser/Host.h>

#include <ctime>
#include <mutex>

namespace candela {

static const llvm::Target *nativeTarget() {
    static const llvm::Target *const target = [] {
        llvm::InitializeNativeTarget();
        llvm::InitializeNativeTargetAsmPrinter();
        std::string error;
        return llvm::TargetRegistry::lookupTarget(llvm::sys::getProcessTriple(), error);
    }();
    return target;
}

using Subtarget = std::unique_ptr<llvm::MCSubtargetInfo>;

static Subtarget subtarget(const std::string &cpu, const std::string &features) {
    return Subtarget(
        nativeTarget()->createMCSubtargetInfo(llvm::sys::getProcessTriple(), cpu, features));
}

static std::string hostFeatures() {
    std::string features;
    for (const auto &feature : llvm::sys::getHostCPUFeatures())
        features += (features.empty() ? "" : ",") + std::string(feature.second ? "+" : "-") +
                    feature.first().str();
    return features;
}

std::string cpuOfLevel(runtime::IsaLevel level) {
    switch (level) {
    case runtime::IsaLevel::V2: return "x86-64-v2";
    case runtime::IsaLevel::V3: return "x86-64-v3";
    case runtime::IsaLevel::V4: break;
    }
    return "x86-64-v4";
}

std::optional<CodeTarget> codeTarget(const std::string &cpu, int width) {
    CodeTarget target;
    target.width = width;
    const bool native = cpu.empty() && instructionSet() == hostInstructionSet();
    target.cpu = native         ? llvm::sys::getHostCPUName().str()
                 : !cpu.empty() ? cpu
                                : cpuOfLevel(runtime::hostIsaLevel());
    // The host may lack what its name promises: hypervisors hide features.
    target.features = native ? hostFeatures() : "";
    if (!subtarget("x86-64", "")->isCPUStringValid(target.cpu))
        return std::nullopt;
    const Subtarget facts = subtarget(target.cpu, target.features);
    if (facts->checkFeatures("+avx512f,+avx512bw,+avx512cd,+avx512dq,+avx512vl"))
        target.level = runtime::IsaLevel::V4;
    else if (facts->checkFeatures("+avx2,+fma"))
        target.level = runtime::IsaLevel::V3;
    return target;
}

bool hostRunsCode(const std::string &cpu) {
    if (cpu.empty())
        return true;
    if (!subtarget("x86-64", "")->isCPUStringValid(cpu))
        return false;
    if (int(codeTarget(cpu, 1)->level) > int(instructionSet()))
        return false;
    const Subtarget wanted = subtarget(cpu, "");
    const auto host = llvm::sys::getHostCPUFeatures();
    for (const auto &feature : wanted->getAllProcessorFeatures()) {
        const auto known = host.find(feature.Key);
        if (wanted->getFeatureBits()[feature.Value] && known != host.end() && !known->second)
            return false;
    }
    return true;
}

std::string llvmVersion() { return LLVM_VERSION_STRING; }

static std::unique_ptr<llvm::TargetMachine> machineFor(const CodeTarget &target) {
    llvm::TargetOptions options;
    options.AllowFPOpFusion = llvm::FPOpFusion::Strict;
    return std::unique_ptr<llvm::TargetMachine>(nativeTarget()->createTargetMachine(
        llvm::sys::getProcessTriple(), target.cpu, target.features, options, llvm::Reloc::PIC_,
        llvm::CodeModel::Small, llvm::CodeGenOptLevel::Default, true));
}

static void optimise(llvm::Module &module, llvm::TargetMachine &machine) {
    llvm::LoopAnalysisManager loops;
    llvm::FunctionAnalysisManager functions;
    llvm::CGSCCAnalysisManager graphs;
    llvm::ModuleAnalysisManager modules;
    llvm::PipelineTuningOptions tuning;
    tuning.LoopVectorization = false;
    tuning.SLPVectorization = false;
    tuning.LoopInterleaving = false;
    llvm::PassBuilder passes(&machine, tuning);
    passes.registerModuleAnalyses(modules);
    passes.registerCGSCCAnalyses(graphs);
    passes.registerFunctionAnalyses(functions);
    passes.registerLoopAnalyses(loops);
    passes.crossRegisterProxies(loops, functions, graphs, modules);
    // One function, nothing to inline: O2's module passes would look about in vain.
    llvm::ModulePassManager pipeline;
    llvm::cantFail(passes.parsePassPipeline(
        pipeline, "function(sroa,early-cse<memssa>,instcombine<no-verify-fixpoint>,simplifycfg,"
                  "loop-mssa(licm<allowspeculation>),loop(loop-deletion),gvn,"
                  "instcombine<no-verify-fixpoint>,adce,simplifycfg)"));
    pipeline.run(module, modules);
}

/// CPU seconds of this thread: several compile at once.
static double threadSeconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

CompilerResult compileFunction(const ir::Function &function, const CodeTarget &target,
                               const std::string &symbol, EmitForm form) {
    CompilerResult result;
    llvm::LLVMContext context;
    llvm::Module module(function.name, context);
    const auto machine = machineFor(target);
    module.setTargetTriple(machine->getTargetTriple().str());
    module.setDataLayout(machine->createDataLayout());

    const double start = threadSeconds();
    generateFunction(function, target, symbol, module);
    llvm::raw_string_ostream errors(result.error);
    if (llvm::verifyModule(module, &errors))
        return result;
    optimise(module, *machine);
    result.secondsOptimising = threadSeconds() - start;

    const double emitStart = threadSeconds();
    llvm::SmallVector<char, 0> bytes;
    llvm::raw_svector_ostream stream(bytes);
    if (form == EmitForm::Ir) {
        module.print(stream, nullptr);
    } else {
        llvm::legacy::PassManager emitter;
        const auto type = form == EmitForm::Object ? llvm::CodeGenFileType::ObjectFile
                                                   : llvm::CodeGenFileType::AssemblyFile;
        if (machine->addPassesToEmitFile(emitter, stream, nullptr, type)) {
            result.error = "the code generator can't emit such files";
            return result;
        }
        emitter.run(module);
    }
    result.bytes.assign(bytes.begin(), bytes.end());
    result.secondsEmitting = threadSeconds() - emitStart;
    return result;
}

} // namespace candela
