// SPDX-License-Identifier: Apache-2.0
#include "language/jit/compiler.h"

#include "foundation/base/instruction_set.h"
#include "language/jit/function_generator.h"
#include "language/jit/llvm_errors.h"
#include "language/jit/machine_pool.h"

#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/DiagnosticPrinter.h>
#include <llvm/IR/LegacyPassManager.h>
#include <llvm/IR/Module.h>
#include <llvm/IR/Verifier.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/TargetParser/Host.h>

#include <ctime>
#include <memory>

namespace candela {

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
    // Nothing to inline: O2's module passes would look about in vain.
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

namespace {

/// What one module is compiled with. Not to be touched after LLVM has given up.
class Compilation {
public:
    Compilation(const std::vector<NamedFunction> &functions, const CodeTarget &target)
        : functions_(functions), target_(target), machine_(lendMachine(target)),
          module_(functions.empty() ? "" : functions[0].function->name, context_) {
        module_.setTargetTriple(machine_->getTargetTriple().str());
        module_.setDataLayout(machine_->createDataLayout());
        context_.setDiagnosticHandlerCallBack(noteError, this);
    }

    void run(EmitForm form) {
        const double start = threadSeconds();
        for (const NamedFunction &each : functions_)
            generateFunction(*each.function, target_, each.symbol, module_);
        llvm::raw_string_ostream errors(result_.error);
        if (llvm::verifyModule(module_, &errors))
            return;
        optimise(module_, *machine_);
        const double optimised = threadSeconds();
        emit(form);
        result_.secondsOptimising = optimised - start;
        result_.secondsEmitting = threadSeconds() - optimised;
    }
    CompilerResult takeResult() { return std::move(result_); }

private:
    /// Instead of LLVM's own, which ends the process.
    static void noteError(const llvm::DiagnosticInfo *info, void *self) {
        if (info->getSeverity() != llvm::DS_Error)
            return;
        llvm::raw_string_ostream text(static_cast<Compilation *>(self)->result_.error);
        llvm::DiagnosticPrinterRawOStream printer(text);
        info->print(printer);
    }

    void emit(EmitForm form) {
        llvm::SmallVector<char, 0> bytes;
        llvm::raw_svector_ostream stream(bytes);
        if (form == EmitForm::Ir) {
            module_.print(stream, nullptr);
        } else {
            llvm::legacy::PassManager emitter;
            const auto type = form == EmitForm::Object ? llvm::CodeGenFileType::ObjectFile
                                                       : llvm::CodeGenFileType::AssemblyFile;
            if (machine_->addPassesToEmitFile(emitter, stream, nullptr, type)) {
                result_.error = "the code generator can't emit such files";
                return;
            }
            emitter.run(module_);
        }
        result_.bytes.assign(bytes.begin(), bytes.end());
    }

    const std::vector<NamedFunction> &functions_;
    const CodeTarget &target_;
    CompilerResult result_;
    LentMachine machine_;
    llvm::LLVMContext context_;
    llvm::Module module_;
};

} // namespace

CompilerResult compileFunctions(const std::vector<NamedFunction> &functions,
                                const CodeTarget &target, EmitForm form) {
    std::unique_ptr<Compilation> compilation;
    CompilerResult result;
    const std::string end = runGuarded([&] {
        compilation = std::make_unique<Compilation>(functions, target);
        compilation->run(form);
    });
    if (end.empty())
        return compilation->takeResult();
    // What LLVM has left behind can't be freed.
    (void)compilation.release();
    result.error = end;
    return result;
}

} // namespace candela
