// SPDX-License-Identifier: Apache-2.0
// The campaign finds what it looks for: inputs that misbehave in each way on purpose.
#include "workers.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <gtest/gtest.h>
#include <map>
#include <memory>

namespace candela::fuzz {
namespace {

enum Misdeed : std::uint64_t { Crash = 3, Hang = 5, RunForEver = 7, Eat = 9, Say = 11, Err = 13 };

void hang() {
    for (volatile bool on = true; on;)
        ;
}

void eat() {
    std::vector<std::unique_ptr<char[]>> eaten;
    for (std::size_t n = 1; n != 0; ++n)
        eaten.emplace_back(new char[50 << 20]);
}

std::string misbehave(std::uint64_t input, Monitor &monitor) {
    monitor.show("text " + std::to_string(input));
    monitor.enter(input == RunForEver ? Stage::Interpret : Stage::Lower, "detail");
    switch (input) {
    case Crash: std::abort();
    case Hang:
    case RunForEver: hang(); break;
    case Eat: eat(); break;
    case Say: std::puts("words"); break;
    case Err: return "is wrong\nvery";
    }
    return {};
}

Limits tightLimits() { return {0.3, 0.3, 300}; }

TEST(Workers, NameEachInputThatFailsAndGoOn) {
    Workers workers(misbehave, tightLimits(), 2);
    std::map<std::uint64_t, Failure> failures;
    workers.run(0, 500, [&](const Failure &failure) { failures[failure.input] = failure; });
    EXPECT_EQ(workers.tally().tried, 500u);
    EXPECT_EQ(workers.tally().endless, 1u);
    const std::map<std::uint64_t, std::string> expected{{Crash, "ends by signal 6"},
                                                        {Hang, "takes more than 0.3 s"},
                                                        {Eat, "takes more than 300 MiB"},
                                                        {Say, "writes to the terminal"},
                                                        {Err, "is wrong"}};
    ASSERT_EQ(failures.size(), expected.size());
    for (const auto &[input, problem] : expected) {
        EXPECT_EQ(failures[input].problem.substr(0, failures[input].problem.find('\n')), problem);
        EXPECT_EQ(failures[input].text, "text " + std::to_string(input));
        EXPECT_EQ(failures[input].stage, Stage::Lower);
        EXPECT_EQ(failures[input].detail, "detail");
    }
}

/// 0.2 s of compilation twice are too much in all, also with a run between that has its own limit.
TEST(Workers, CompilationHasOneAllowanceAndRunsHaveAnother) {
    const auto subjectWith = [](int compilations) {
        return [compilations](std::uint64_t, Monitor &monitor) -> std::string {
            const auto spend = [](double seconds) {
                for (const std::clock_t begin = std::clock();
                     double(std::clock() - begin) < seconds * CLOCKS_PER_SEC;)
                    ;
            };
            monitor.show("");
            for (int n = 0; n < compilations; ++n) {
                monitor.enter(Stage::Lower, "");
                spend(0.2);
                monitor.enter(Stage::Interpret, "");
                spend(0.2);
            }
            return {};
        };
    };
    EXPECT_EQ(tryAlone(subjectWith(1), tightLimits(), 0).problem, "");
    EXPECT_EQ(tryAlone(subjectWith(2), tightLimits(), 0).problem, "takes more than 0.3 s");
}

} // namespace
} // namespace candela::fuzz
