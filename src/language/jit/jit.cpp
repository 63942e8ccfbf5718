// SPDX-License-Identifier: Apache-2.0
#include "language/jit/jit.h"

#include "language/jit/compiler.h"
#include "language/jit/function_hash.h"
#include "language/jit/object_cache.h"
#include "language/jit/print_lanes.h"
#include "language/jit/runtime_symbols.h"
#include "language/runtime/register_code.h"
#include "language/runtime/vector_math.h"

#include <llvm/ExecutionEngine/Orc/LLJIT.h>

#include <condition_variable>
#include <cstring>
#include <map>
#include <mutex>

namespace candela {

namespace orc = llvm::orc;

struct Jit::State {
    State(const JitOptions &, DiagnosticSink &);

    void createLinker();
    void defineSymbols();
    std::string keyOf(const ir::Function &) const;
    ShaderFunction make(const ir::Function &, const std::string &key);
    ShaderFunction link(const std::string &object, const std::string &symbol);
    std::string compileObject(const ir::Function &, const std::string &symbol);
    void fail(const std::string &what);

    JitOptions options;
    DiagnosticSink &sink;
    std::optional<CodeTarget> target;
    ObjectCache cache;
    std::unique_ptr<orc::LLJIT> linker;

    std::mutex mutex;
    std::condition_variable made;
    /// By key: null while a thread is at it.
    std::map<std::string, std::optional<ShaderFunction>> functions;
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
    if (target)
        createLinker();
    else
        fail("no code can be generated for CPU \"" + cpuOf(given) + "\" at width " +
             std::to_string(given.width));
}

void Jit::State::createLinker() {
    auto created = orc::LLJITBuilder().setPlatformSetUp(orc::setUpInactivePlatform).create();
    if (!created)
        return fail(llvm::toString(created.takeError()));
    linker = std::move(*created);
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
    define(printSymbol, &printLanes);
    define(indexOutsideSymbol, &reportIndexOutside);
    define("memset", &std::memset);
    define("memcpy", &std::memcpy);
    define("memmove", &std::memmove);
    if (auto error = linker->getMainJITDylib().define(orc::absoluteSymbols(std::move(symbols)))) {
        fail(llvm::toString(std::move(error)));
        linker.reset();
    }
}

std::string Jit::State::keyOf(const ir::Function &function) const {
    ContentHash hash;
    hash.add(std::string_view(CANDELA_CODEGEN_HASH));
    hash.add(llvmVersion());
    hash.add(target->cpu);
    hash.add(target->features);
    hash.add(std::uint64_t(target->width));
    addFunction(hash, function);
    return hash.text();
}

void Jit::State::fail(const std::string &what) {
    sink.error({}, "compiling a shader failed: " + what);
}

std::string Jit::State::compileObject(const ir::Function &function, const std::string &symbol) {
    CompilerResult result = compileFunction(function, *target, symbol, EmitForm::Object);
    if (!result.error.empty())
        fail(function.name + ": " + result.error);
    std::lock_guard lock(mutex);
    ++statistics.compiled;
    statistics.secondsOptimising += result.secondsOptimising;
    statistics.secondsEmitting += result.secondsEmitting;
    return result.error.empty() ? result.bytes : std::string();
}

ShaderFunction Jit::State::link(const std::string &object, const std::string &symbol) {
    auto buffer = llvm::MemoryBuffer::getMemBufferCopy(object, symbol);
    if (auto error = linker->addObjectFile(std::move(buffer))) {
        fail(llvm::toString(std::move(error)));
        return nullptr;
    }
    auto address = linker->lookup(symbol);
    if (!address) {
        fail(llvm::toString(address.takeError()));
        return nullptr;
    }
    return address->toPtr<ShaderFunction>();
}

ShaderFunction Jit::State::make(const ir::Function &function, const std::string &key) {
    const std::string symbol = "shader_" + key;
    if (const auto stored = cache.load(key)) {
        {
            std::lock_guard lock(mutex);
            ++statistics.fromCache;
        }
        return link(*stored, symbol);
    }
    const std::string object = compileObject(function, symbol);
    if (object.empty())
        return nullptr;
    cache.store(key, object);
    return link(object, symbol);
}

Jit::Jit(JitOptions options, DiagnosticSink &sink)
    : state_(std::make_unique<State>(options, sink)) {}

Jit::~Jit() = default;

ShaderFunction Jit::compile(const ir::Function &function) {
    State &state = *state_;
    if (!state.linker)
        return nullptr;
    const std::string key = state.keyOf(function);
    {
        std::unique_lock lock(state.mutex);
        auto [entry, isNew] = state.functions.try_emplace(key);
        if (!isNew) {
            state.made.wait(lock, [&] { return entry->second.has_value(); });
            return *entry->second;
        }
    }
    const ShaderFunction code = state.make(function, key);
    {
        std::lock_guard lock(state.mutex);
        state.functions[key] = code;
    }
    state.made.notify_all();
    return code;
}

std::string Jit::emit(const ir::Function &function, bool assembly) {
    if (!state_->target)
        return {};
    CompilerResult result = compileFunction(function, *state_->target, "shader",
                                            assembly ? EmitForm::Assembly : EmitForm::Ir);
    if (!result.error.empty())
        state_->fail(function.name + ": " + result.error);
    return result.bytes;
}

bool Jit::hostRuns(const std::string &cpu) { return hostRunsCode(cpu); }
bool Jit::hostRuns(runtime::IsaLevel level) { return hostRunsCode(cpuOfLevel(level)); }

Jit::Statistics Jit::statistics() const {
    std::lock_guard lock(state_->mutex);
    return state_->statistics;
}

} // namespace candela
