// SPDX-License-Identifier: Apache-2.0
#include "language/jit/jit.h"

#include "language/jit/compiler.h"
#include "language/jit/function_hash.h"
#include "language/jit/llvm_errors.h"
#include "language/jit/object_cache.h"
#include "language/jit/reports.h"
#include "language/jit/runtime_symbols.h"
#include "language/runtime/register_code.h"
#include "language/runtime/vector_math.h"

#include <llvm/ExecutionEngine/Orc/LLJIT.h>

#include <cmath>
#include <condition_variable>
#include <cstring>
#include <map>
#include <mutex>

namespace candela {

namespace orc = llvm::orc;

using Functions = std::span<const ir::Function *const>;
using Codes = std::vector<ShaderFunction>;

static std::string failure(const std::string &of, const std::string &why) {
    return "no code can be made for " + of + ": " + why;
}

struct Jit::State {
    State(const JitOptions &, DiagnosticSink &);

    void createLinker();
    void defineSymbols();
    std::string keyOf(Functions) const;
    Codes make(Functions, const std::string &key, DiagnosticSink &);
    /// No codes, and what is wrong, if the object can't be linked.
    Codes link(const std::string &object, const std::vector<NamedFunction> &, std::string &error);
    std::string compileObject(const std::vector<NamedFunction> &, std::string &error);

    JitOptions options;
    DiagnosticSink &sink;
    std::optional<CodeTarget> target;
    ObjectCache cache;
    std::unique_ptr<orc::LLJIT> linker;

    std::mutex mutex;
    std::condition_variable made;
    /// By key: null while a thread is at it.
    std::map<std::string, std::optional<Codes>> modules;
    int linked = 0; ///< Objects.
    Statistics statistics;
};

/// LLVM's name for the machines that code is to run on; empty = this one.
static std::string cpuOf(const JitOptions &options) {
    return options.cpu.empty() && options.level ? cpuOfLevel(*options.level) : options.cpu;
}

Jit::State::State(const JitOptions &given, DiagnosticSink &diagnostics)
    : options(given), sink(diagnostics), target(codeTarget(cpuOf(given), given.width)),
      cache(!given.useCache             ? std::filesystem::path()
            : given.cacheFolder.empty() ? ObjectCache::defaultFolder()
                                        : std::filesystem::path(given.cacheFolder)) {
    if (given.width != 1 && given.width != laneBlock)
        target.reset();
    if (target && given.longestFunction > 0)
        target->longestFunction = given.longestFunction;
    if (target)
        createLinker();
    else
        sink.error({},
                   failure("CPU \"" + cpuOf(given) + "\" at width " + std::to_string(given.width),
                           "LLVM knows no such CPU or width"));
}

void Jit::State::createLinker() {
    auto created = orc::LLJITBuilder().setPlatformSetUp(orc::setUpInactivePlatform).create();
    if (!created)
        return sink.error({}, failure("this process", llvm::toString(created.takeError())));
    linker = std::move(*created);
    // Errors come back from where they are met as well, and are reported there.
    linker->getExecutionSession().setErrorReporter(
        [](llvm::Error error) { llvm::consumeError(std::move(error)); });
    defineSymbols();
}

/// Everything that generated code calls, by name, so that stored objects link again wherever the
/// libraries lie in memory.
void Jit::State::defineSymbols() {
    orc::SymbolMap symbols;
    const auto define = [&](const std::string &name, auto *address) {
        symbols[linker->mangleAndIntern(name)] = {
            orc::ExecutorAddr(reinterpret_cast<std::uintptr_t>(address)),
            llvm::JITSymbolFlags::Exported | llvm::JITSymbolFlags::Callable};
    };
    for (int k = 0; k < int(runtime::MathFunction::Count); ++k) {
        const auto function = runtime::MathFunction(k);
        for (const auto &code : {runtime::scalarMath(function, target->level),
                                 runtime::vectorMath(function, target->level)})
            define(code.name, code.address);
    }
    for (int k = 0; k < int(runtime::RuntimeFunction::Count); ++k)
        for (int width : {1, runtime::registerLanes(target->level)})
            define(runtimeSymbol(k, width),
                   runtime::registerCode(runtime::RuntimeFunction(k), width, target->level));
    define(serviceSymbol, &askFromCode);
    define(indexOutsideSymbol, &reportIndexOutside);
    define(loopEndedSymbol, &reportLoopEnded);
    define(lookUpSymbol, &runtime::lookUpFromCode);
    define(setImageSymbol, &runtime::setFromCode);
    define(pixelLoopSymbol, &runtime::runPixelLoop);
    define(goesOnSymbol, &runtime::filterGoesOn);
    define("memset", &std::memset);
    define("memcpy", &std::memcpy);
    define("memmove", &std::memmove);
    define("fmaf", &fmaf);
    if (auto error = linker->getMainJITDylib().define(orc::absoluteSymbols(std::move(symbols)))) {
        sink.error({}, failure("this process", llvm::toString(std::move(error))));
        linker.reset();
    }
}

std::string Jit::State::keyOf(Functions functions) const {
    ContentHash hash;
    hash.add(std::string_view(CANDELA_CODEGEN_HASH));
    hash.add(llvmVersion());
    hash.add(target->cpu);
    hash.add(target->features);
    hash.add(std::uint64_t(target->width));
    hash.add(std::uint64_t(target->longestFunction));
    for (const ir::Function *function : functions)
        addFunction(hash, *function);
    return hash.text();
}

std::string Jit::State::compileObject(const std::vector<NamedFunction> &functions,
                                      std::string &error) {
    CompilerResult result = compileFunctions(functions, *target, EmitForm::Object);
    error = result.error;
    std::lock_guard lock(mutex);
    statistics.compiled += int(functions.size());
    statistics.secondsOptimising += result.secondsOptimising;
    statistics.secondsEmitting += result.secondsEmitting;
    return std::move(result.bytes);
}

Codes Jit::State::link(const std::string &object, const std::vector<NamedFunction> &functions,
                       std::string &error) {
    Codes codes;
    const std::string end = runGuarded([&] {
        std::string name;
        {
            std::lock_guard lock(mutex);
            name = "object " + std::to_string(linked++);
        }
        // A library of its own: what a bad object leaves behind is in nobody's way.
        auto library = linker->createJITDylib(name);
        if (!library)
            return void(error = llvm::toString(library.takeError()));
        auto buffer = llvm::MemoryBuffer::getMemBufferCopy(object, functions[0].symbol);
        library->addToLinkOrder(linker->getMainJITDylib());
        if (auto problem = linker->addObjectFile(*library, std::move(buffer)))
            return void(error = llvm::toString(std::move(problem)));
        for (const NamedFunction &each : functions) {
            auto address = linker->lookup(*library, each.symbol);
            if (!address)
                return void(error = llvm::toString(address.takeError()));
            codes.push_back(address->toPtr<ShaderFunction>());
        }
    });
    if (error.empty())
        error = end;
    return error.empty() ? codes : Codes();
}

Codes Jit::State::make(Functions given, const std::string &key, DiagnosticSink &told) {
    std::vector<NamedFunction> functions;
    for (const ir::Function *function : given)
        functions.push_back({function, "shader_" + key + "_" + std::to_string(functions.size())});
    const auto stored = cache.load(key);
    if (const std::string objection = cache.takeObjection(); !objection.empty())
        sink.warning({}, objection);
    std::string error;
    if (stored) {
        if (Codes codes = link(*stored, functions, error); !codes.empty()) {
            std::lock_guard lock(mutex);
            statistics.fromCache += int(codes.size());
            return codes;
        }
        // Whatever has become of it: it can be made again.
        cache.remove(key);
        error.clear();
    }
    const std::string object = compileObject(functions, error);
    Codes codes = error.empty() ? link(object, functions, error) : Codes();
    if (codes.empty()) {
        told.error({}, failure(given[0]->name, error));
        return Codes(functions.size());
    }
    cache.store(key, object);
    return codes;
}

Jit::Jit(JitOptions options, DiagnosticSink &sink)
    : state_(std::make_unique<State>(options, sink)) {}

Jit::~Jit() = default;

ShaderFunction Jit::compile(const ir::Function &function) {
    const ir::Function *one[] = {&function};
    return compile(one, state_->sink)[0];
}

std::vector<ShaderFunction> Jit::compile(std::span<const ir::Function *const> functions,
                                         DiagnosticSink &told) {
    State &state = *state_;
    if (!state.linker || functions.empty())
        return Codes(functions.size());
    const std::string key = state.keyOf(functions);
    {
        std::unique_lock lock(state.mutex);
        auto [entry, isNew] = state.modules.try_emplace(key);
        if (!isNew) {
            state.made.wait(lock, [&] { return entry->second.has_value(); });
            return *entry->second;
        }
    }
    Codes codes = state.make(functions, key, told);
    {
        std::lock_guard lock(state.mutex);
        state.modules[key] = codes;
    }
    state.made.notify_all();
    return codes;
}

std::string Jit::emit(const ir::Function &function, bool assembly) {
    if (!state_->target)
        return {};
    CompilerResult result = compileFunctions({{&function, "shader"}}, *state_->target,
                                             assembly ? EmitForm::Assembly : EmitForm::Ir);
    if (!result.error.empty())
        state_->sink.error({}, failure(function.name, result.error));
    return result.bytes;
}

bool Jit::fusesProducts() const {
    return state_->target && state_->target->level != runtime::IsaLevel::V2;
}

bool Jit::hostRuns(const std::string &cpu) { return hostRunsCode(cpu); }
bool Jit::hostRuns(runtime::IsaLevel level) { return hostRunsCode(cpuOfLevel(level)); }

Jit::Statistics Jit::statistics() const {
    std::lock_guard lock(state_->mutex);
    return state_->statistics;
}

} // namespace candela
