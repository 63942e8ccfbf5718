// SPDX-License-Identifier: Apache-2.0
// For tests: services that note who asks them, and answer.
#pragma once

#include "language/ir/core/print_format.h"
#include "language/runtime/shader_abi.h"

#include <bit>
#include <compare>
#include <set>
#include <string>
#include <vector>

namespace candela::ir {

/// Services of tests' own, answered where `option` and `print` are in the product: by two numbers;
/// by the lane's object; told anything.
inline constexpr ServiceInfo testSample{"sample",
                                        Service::option,
                                        1,
                                        "ff",
                                        "*",
                                        ServicePurity::Query,
                                        ServiceUniformity::Operands,
                                        300,
                                        ServiceSlope::Held,
                                        ServiceBound::Unknown};
inline constexpr ServiceInfo testObject{"object",
                                        Service::option,
                                        1,
                                        "",
                                        "*",
                                        ServicePurity::Query,
                                        ServiceUniformity::Varying,
                                        300,
                                        ServiceSlope::Step,
                                        ServiceBound::Unknown};
inline constexpr ServiceInfo testNote{"note",
                                      Service::print,
                                      1,
                                      "*",
                                      "",
                                      ServicePurity::Command,
                                      ServiceUniformity::Varying,
                                      300,
                                      ServiceSlope::None,
                                      ServiceBound::None};

/// One lane asked. The lane of what is asked once for all lanes is one of them.
struct LaneAsked {
    std::string service, text;
    int lane = 0;
    std::vector<std::int32_t> operands; ///< Bits.
    auto operator<=>(const LaneAsked &) const = default;
};

struct ServiceLog {
    std::multiset<LaneAsked> lanes;
    std::vector<int> widths, asking; ///< Of each call: lanes in a row, and in the mask.

    int count(std::string_view text, int lane) const {
        int sum = 0;
        for (const LaneAsked &asked : lanes)
            sum += asked.text == text && asked.lane == lane;
        return sum;
    }
};

inline void noteService(void *log, const ServiceCall &call) {
    if (!log)
        return;
    auto &to = *static_cast<ServiceLog *>(log);
    to.widths.push_back(call.laneCount);
    to.asking.push_back(std::popcount(call.mask));
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        LaneAsked asked{call.site->name, call.text(lane), call.firstLane + lane, {}};
        for (int k = 0; k < call.site->operandCount - !call.hasOneText(); ++k)
            asked.operands.push_back(call.operand(k, lane).integer);
        to.lanes.insert(std::move(asked));
    }
}

/// The lines that lanes print; the sign of NaN, which is not defined, is left out.
inline std::vector<std::string> printedLines(const ServiceCall &call) {
    std::vector<std::string> lines;
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        std::string &line = lines.emplace_back(printedText(call, lane));
        for (std::size_t at; (at = line.find("-nan")) != std::string::npos;)
            line.erase(at, 1);
    }
    return lines;
}

/// A number that tells operands and places of results apart; the same at all widths.
inline void answerService(void *log, const ServiceCall &call) {
    noteService(log, call);
    const bool perObject = std::string_view(call.site->name) == testObject.name;
    for (int lane = 0; lane < call.laneCount; ++lane)
        for (int k = 0; k < call.site->resultCount && call.asks(lane); ++k) {
            float answer = 0.25f * float(k);
            if (perObject)
                answer += float(call.args->objectIndex[call.firstLane + lane]);
            for (int n = 0; n < call.site->operandCount - !call.hasOneText(); ++n)
                answer = answer * 0.5f + call.operand(n, lane).number;
            call.result(k, lane) = answer;
        }
}

inline ShaderServices testServices(ServiceLog *log = nullptr) {
    ShaderServices services;
    services.context = log;
    services[Service::print] = noteService;
    services[Service::option] = answerService;
    return services;
}

} // namespace candela::ir
