// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_messages.h"

#include <mutex>

namespace candela {

ShaderMessages::ShaderMessages(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {
    callbacks_.context = this;
    callbacks_.indexOutside = [](void *context, const char *file, std::int32_t line) {
        static_cast<ShaderMessages *>(context)->indexOutside(file, line);
    };
    callbacks_.loopEnded = [](void *context, const char *file, std::int32_t line) {
        static_cast<ShaderMessages *>(context)->loopEnded(file, line);
    };
    callbacks_.serviceAbsent = [](void *context, const char *service, const char *file,
                                  std::int32_t line) {
        static_cast<ShaderMessages *>(context)->serviceAbsent(service, file, line);
    };
}

bool ShaderMessages::isNew(Mistake mistake, std::string_view file, int line) {
    Places &said = said_[std::size_t(mistake)];
    {
        std::shared_lock lock(mutex_);
        const auto lines = said.find(file);
        if (lines != said.end() && lines->second.contains(line))
            return false;
    }
    std::lock_guard lock(mutex_);
    return said[std::string(file)].insert(line).second;
}

void ShaderMessages::indexOutside(std::string_view file, int line) {
    if (isNew(Mistake::Index, file, line))
        diagnostics_.warning({std::make_shared<const std::string>(file), line},
                             "an index here is outside the array at some points: the nearest "
                             "element is taken");
}

void ShaderMessages::loopEnded(std::string_view file, int line) {
    if (isNew(Mistake::Loop, file, line))
        diagnostics_.error({std::make_shared<const std::string>(file), line},
                           "the loop here does not end at some points, or takes more turns than "
                           "Option \"shading\" \"loopturns\" allows: they are black");
}

void ShaderMessages::serviceAbsent(std::string_view service, std::string_view file, int line) {
    if (isNew(Mistake::Service, file, line))
        diagnostics_.error({std::make_shared<const std::string>(file), line},
                           "nothing in this renderer answers what is asked here (" +
                               std::string(service) + "): the answer is 0");
}

} // namespace candela
