// SPDX-License-Identifier: Apache-2.0
// Services: how generated code, at every width, and the interpreter ask the renderer. The table is
// services.def, the rules stand in docs/contracts.md.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>

namespace candela {

struct ShaderArgs;

enum class Service : std::int32_t {
#define SERVICE(name, ...) name,
#include "language/runtime/services.def"
#undef SERVICE
    Count
};
inline constexpr int serviceCount = int(Service::Count);

enum class ServicePurity : std::uint8_t { Query, Command };
enum class ServiceUniformity : std::uint8_t { Operands, Varying };
enum class ServiceSlope : std::uint8_t { None, Step, Held, Twin };
enum class ServiceBound : std::uint8_t { None, Unknown, Constant };

/// As services.def explains it.
struct ServiceInfo {
    const char *name;
    Service service; ///< Whom to ask.
    int texts;
    std::string_view operands, results;
    ServicePurity purity;
    ServiceUniformity uniformity;
    int cost;
    ServiceSlope slope;
    ServiceBound bound;
};

inline constexpr ServiceInfo serviceTable[] = {
#define SERVICE(name, texts, operands, results, purity, uniformity, cost, slope, bound, meaning)   \
    {#name,                                                                                        \
     Service::name,                                                                                \
     texts,                                                                                        \
     operands,                                                                                     \
     results,                                                                                      \
     ServicePurity::purity,                                                                        \
     ServiceUniformity::uniformity,                                                                \
     cost,                                                                                         \
     ServiceSlope::slope,                                                                          \
     ServiceBound::bound},
#include "language/runtime/services.def"
#undef SERVICE
};

constexpr const ServiceInfo &info(Service service) { return serviceTable[int(service)]; }

/// How many operands the derivatives of a service with a twin are by.
inline constexpr int twinCoordinates = 2;
/// The service that gives a service's answer and its derivatives; of those that have a twin.
constexpr const ServiceInfo &twinOf(const ServiceInfo &service) {
    return serviceTable[int(service.service) + 1];
}

/// What is the same in all calls from one place. Generated code lays it out itself
/// (jit/service_calls.cpp).
struct ServiceSite {
    const char *name; ///< Of the service.
    Service service;
    std::int32_t operandCount, resultCount;
    std::int32_t line;        ///< Of the source; 0 = the compiler's own.
    const char *file;         ///< Likewise; never null.
    const char *const *texts; ///< The constant strings; see ServiceCall::text().
    const char *types;        ///< A letter an operand: f float, i integer or bool, s string.
    /// Where operands that are strings stand: see ServiceCall::string().
    const char *strings;
};

union ServiceCell {
    float number;
    std::int32_t integer;
};

/// A question from some lanes of a block. Only the lanes in the mask ask: what the others'
/// operands hold means nothing, and nobody reads their results.
struct ServiceCall {
    const ShaderArgs *args; ///< Of the batch.
    const ServiceSite *site;
    /// Rows are of `laneCount` lanes, from lane `firstLane` of the batch on. A row of one lane
    /// stands for all lanes that ask, if all of them ask the same and the answer depends on
    /// nothing else; `firstLane` is one of them.
    std::int32_t firstLane, laneCount;
    std::uint32_t mask;          ///< Bit k: lane firstLane + k asks; never 0.
    const ServiceCell *operands; ///< Operand k of lane j: operands[k * laneCount + j].
    float *results;              ///< Likewise; zeros when the service is called.

    bool asks(int lane) const { return mask >> lane & 1; }
    ServiceCell operand(int k, int lane) const { return operands[k * laneCount + lane]; }
    /// An operand that is a string.
    const char *string(int k, int lane) const;
    /// Text 0, which may be another in each lane: it is the last operand then, and null in the
    /// site's list. Equal ones are equal operands.
    bool hasOneText() const { return site->texts[0] != nullptr; }
    const char *text(int lane) const {
        return hasOneText() ? site->texts[0] : string(site->operandCount - 1, lane);
    }
    float &result(int k, int lane) const { return results[k * laneCount + lane]; }
};

/// Strings that instances give, by their numbers. Strings are integers where code runs: those of
/// its own are offsets into ServiceSite::strings, these are below 0.
struct StringTable {
    const char *const *strings = nullptr;
    std::int32_t count = 0;
};
/// A string of the table; of numbers that it has not, an empty one.
constexpr std::int32_t stringOfNumber(std::int32_t number) {
    return ~number | std::numeric_limits<std::int32_t>::min();
}

/// Called from any thread.
using ServiceFunction = void (*)(void *context, const ServiceCall &);

/// Who answers. A service that is null gives zeros, and ShaderCallbacks::serviceAbsent is told.
struct ShaderServices {
    void *context = nullptr;
    std::array<ServiceFunction, serviceCount> functions{}; ///< By Service.
    StringTable strings;

    ServiceFunction &operator[](Service service) { return functions[std::size_t(service)]; }
};

/// Makes a call: results are cleared, and whoever answers is asked if any lane asks. `call.args`,
/// `site`, `operands` and `results` are set; a row of one lane has the mask of all lanes that it
/// stands for, from `firstLane` on.
void askService(ServiceCall call);

} // namespace candela
