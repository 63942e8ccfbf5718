// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/services.h"

#include "language/runtime/shader_abi.h"

#include <algorithm>
#include <bit>

namespace candela {

static void reportAbsent(const ServiceCall &call) {
    const ShaderCallbacks *callbacks = call.args->callbacks;
    if (callbacks && callbacks->serviceAbsent)
        callbacks->serviceAbsent(callbacks->context, call.site->name, call.site->file,
                                 call.site->line);
}

const char *ServiceCall::string(int k, int lane) const {
    const std::int32_t string = operand(k, lane).integer;
    if (string >= 0)
        return site->strings + string;
    const StringTable none, &table = args->services ? args->services->strings : none;
    const std::int32_t number = ~string;
    return number < table.count ? table.strings[number] : "";
}

void askService(ServiceCall call) {
    std::fill_n(call.results, call.site->resultCount * call.laneCount, 0.0f);
    if (call.mask == 0)
        return;
    if (call.laneCount == 1) {
        call.firstLane += std::countr_zero(call.mask);
        call.mask = 1;
    }
    const ShaderServices *services = call.args->services;
    const ServiceFunction function =
        services ? services->functions[std::size_t(call.site->service)] : nullptr;
    function ? function(services->context, call) : reportAbsent(call);
}

} // namespace candela
