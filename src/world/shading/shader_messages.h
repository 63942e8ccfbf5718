// SPDX-License-Identifier: Apache-2.0
// What shaders say while they run: printf() on standard output, mistakes as warnings.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/runtime/shader_abi.h"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <shared_mutex>
#include <string>
#include <string_view>

namespace candela {

/// Receives the callbacks of all shaders of a scene, from any thread. Must outlive their calls.
class ShaderMessages {
public:
    explicit ShaderMessages(DiagnosticSink &);
    ShaderMessages(const ShaderMessages &) = delete;
    ShaderMessages &operator=(const ShaderMessages &) = delete;

    const ShaderCallbacks &callbacks() const { return callbacks_; }

private:
    enum class Mistake : std::uint8_t { Index, Loop, Service, Count };

    /// True the first time that the place is named for the kind of mistake.
    bool isNew(Mistake, std::string_view file, int line);
    void indexOutside(std::string_view file, int line);
    void loopEnded(std::string_view file, int line);
    void serviceAbsent(std::string_view service, std::string_view file, int line);

    DiagnosticSink &diagnostics_;
    ShaderCallbacks callbacks_;
    std::shared_mutex mutex_; ///< A shader that is wrong everywhere only reads what was said.
    using Places = std::map<std::string, std::set<int>, std::less<>>; ///< Lines by file.
    std::array<Places, std::size_t(Mistake::Count)> said_;
};

} // namespace candela
