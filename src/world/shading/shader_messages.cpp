// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_messages.h"

#include <cstdio>
#include <mutex>

namespace candela {

ShaderMessages::ShaderMessages(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {
    callbacks_.context = this;
    // Lines of points that are shaded side by side come in any order but whole: POSIX locks the
    // stream for the time of a call.
    callbacks_.print = [](void *, const char *text) { std::fputs(text, stdout); };
    callbacks_.indexOutside = [](void *context, const char *file, std::int32_t line) {
        static_cast<ShaderMessages *>(context)->indexOutside(file, line);
    };
    callbacks_.loopEnded = [](void *context, const char *file, std::int32_t line) {
        static_cast<ShaderMessages *>(context)->loopEnded(file, line);
    };
    silent_ = callbacks_;
    silent_.print = nullptr;
}

bool ShaderMessages::isNew(std::string_view mistake, std::string_view file, int line) {
    std::string key(mistake);
    key += file;
    {
        std::shared_lock lock(mutex_);
        const auto lines = said_.find(key);
        if (lines != said_.end() && lines->second.contains(line))
            return false;
    }
    std::lock_guard lock(mutex_);
    return said_[key].insert(line).second;
}

void ShaderMessages::indexOutside(std::string_view file, int line) {
    if (isNew("index ", file, line))
        diagnostics_.warning({std::make_shared<const std::string>(file), line},
                             "an index here is outside the array at some points: the nearest "
                             "element is taken");
}

void ShaderMessages::loopEnded(std::string_view file, int line) {
    if (isNew("loop ", file, line))
        diagnostics_.error({std::make_shared<const std::string>(file), line},
                           "the loop here does not end at some points, or takes more turns than "
                           "Option \"shading\" \"loopturns\" allows: they are black");
}

} // namespace candela
