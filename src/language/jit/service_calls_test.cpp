// SPDX-License-Identifier: Apache-2.0
// Who is asked: services that count, under all control flow, on every level, at both widths and in
// the interpreter. What is expected is worked out from the inputs alone.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/jit/jit.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>

namespace candela {
namespace {

using ir::Builder;
using ir::ServiceLog;
using ir::TestBatch;
using ir::ValueId;
using ir::Values;

/// A lane's inputs.
struct LaneInputs {
    float x, y, uniform;
    int light = 0; ///< Samples that are not black.
};

/// Asks for something by its name, with effects and without; gives a number.
using Ask = std::function<ValueId(const char *text, ValueId with)>;

struct Control {
    const char *name;
    std::function<void(Builder &, const Ask &)> write;
    /// How often the lane asks for the text.
    std::function<int(const LaneInputs &, std::string_view text)> times;
    int mostTurns = ir::mostLoopTurns;
};

ValueId x(Builder &b) { return input(b, ShaderInput::P, 0); }
ValueId y(Builder &b) { return input(b, ShaderInput::P, 1); }
ValueId uniform(Builder &b) { return currentFromSpace(b, "uniform")[0]; }
ValueId isNegative(Builder &b, ValueId v) { return less(b, v, number(b, 0)); }

ValueId choose(Builder &b, ValueId condition, const std::function<ValueId()> &then,
               const std::function<ValueId()> &otherwise) {
    return ifElse(
        b, condition, [&] { return Values{then()}; }, [&] { return Values{otherwise()}; })[0];
}

/// for (turn = 0; turn < end; ++turn) sum += body(turn)
ValueId counted(Builder &b, ValueId end, const std::function<ValueId(ValueId)> &body) {
    const ValueId zero = number(b, 0);
    return loop(b, {less(b, zero, end), zero, zero}, [&](const Values &carried) {
        const ValueId sum = add(b, carried[2], body(carried[1]));
        const ValueId next = add(b, carried[1], number(b, 1));
        return Values{less(b, next, end), next, sum};
    })[2];
}

void result(Builder &b, ValueId v) { output(b, "result", 0, v); }

int turns(float end) { return end > 0 ? int(std::ceil(end)) : 0; }

ValueId timesFour(Builder &b, ValueId v) { return mul(b, v, number(b, 4)); }

const std::vector<Control> &controls() {
    static const std::vector<Control> all = {
        {"straight", [](Builder &b, const Ask &ask) { result(b, ask("a", x(b))); },
         [](const LaneInputs &, std::string_view) { return 1; }},
        {"varying if",
         [](Builder &b, const Ask &ask) {
             result(b, choose(
                           b, isNegative(b, x(b)), [&] { return ask("then", x(b)); },
                           [&] { return ask("else", y(b)); }));
         },
         [](const LaneInputs &in, std::string_view text) {
             return int((in.x < 0) == (text == "then"));
         }},
        {"varying if with a side that does not ask",
         [](Builder &b, const Ask &ask) {
             result(b, choose(
                           b, isNegative(b, x(b)), [&] { return number(b, 2); },
                           [&] { return ask("else", y(b)); }));
         },
         [](const LaneInputs &in, std::string_view) { return int(!(in.x < 0)); }},
        {"nested ifs",
         [](Builder &b, const Ask &ask) {
             result(b, choose(
                           b, isNegative(b, x(b)),
                           [&] {
                               return choose(
                                   b, isNegative(b, y(b)), [&] { return ask("both", x(b)); },
                                   [&] { return number(b, 1); });
                           },
                           [&] { return number(b, 3); }));
         },
         [](const LaneInputs &in, std::string_view) { return int(in.x < 0 && in.y < 0); }},
        {"uniform if",
         [](Builder &b, const Ask &ask) {
             result(b, choose(
                           b, isNegative(b, uniform(b)), [&] { return ask("then", x(b)); },
                           [&] { return ask("else", y(b)); }));
         },
         [](const LaneInputs &in, std::string_view text) {
             return int((in.uniform < 0) == (text == "then"));
         }},
        {"uniform if in a varying one",
         [](Builder &b, const Ask &ask) {
             result(b, choose(
                           b, isNegative(b, x(b)),
                           [&] {
                               return choose(
                                   b, isNegative(b, uniform(b)), [&] { return ask("a", x(b)); },
                                   [&] { return ask("b", x(b)); });
                           },
                           [&] { return number(b, 3); }));
         },
         [](const LaneInputs &in, std::string_view text) {
             return int(in.x < 0 && (in.uniform < 0) == (text == "a"));
         }},
        {"varying loop",
         [](Builder &b, const Ask &ask) {
             result(b, counted(b, timesFour(b, x(b)),
                               [&](ValueId turn) { return ask("turn", turn); }));
         },
         [](const LaneInputs &in, std::string_view) { return turns(4 * in.x); }},
        {"uniform loop",
         [](Builder &b, const Ask &ask) {
             result(b, counted(b, timesFour(b, uniform(b)),
                               [&](ValueId turn) { return ask("turn", add(b, turn, x(b))); }));
         },
         [](const LaneInputs &in, std::string_view) { return turns(4 * in.uniform); }},
        {"if in a loop in an if",
         [](Builder &b, const Ask &ask) {
             const auto turn = [&](ValueId number_) {
                 return choose(
                     b, less(b, number_, number(b, 1)), [&] { return ask("first", x(b)); },
                     [&] { return ask("later", number_); });
             };
             result(b, choose(
                           b, isNegative(b, y(b)),
                           [&] { return counted(b, timesFour(b, x(b)), turn); },
                           [&] { return number(b, 0); }));
         },
         [](const LaneInputs &in, std::string_view text) {
             const int all = in.y < 0 ? turns(4 * in.x) : 0;
             return text == "first" ? std::min(all, 1) : std::max(all - 1, 0);
         }},
        {"illuminance",
         [](Builder &b, const Ask &ask) {
             result(b,
                    lightLoop(b, addRequest(b, {}), input3(b, ShaderInput::P), {}, {number(b, 0)},
                              [&](const ir::LoopLight &light, const Values &carried) {
                                  return Values{add(b, carried[0], ask("lit", light.L[0]))};
                              })[0]);
         },
         [](const LaneInputs &in, std::string_view) { return in.light; }},
        // Ended after two turns; nobody is asked from there on.
        {"loops that are ended",
         [](Builder &b, const Ask &ask) {
             const ValueId sum =
                 counted(b, timesFour(b, x(b)), [&](ValueId turn) { return ask("turn", turn); });
             result(b, add(b, sum, ask("after", y(b))));
         },
         [](const LaneInputs &in, std::string_view text) {
             const int all = turns(4 * in.x);
             return text == "after" ? int(all <= 2) : std::min(all, 2);
         },
         2}};
    return all;
}

enum class Asked { Query, Object, Command };

ir::Function program(const Control &control, Asked asked) {
    ir::Function function;
    function.mostTurns = control.mostTurns;
    Builder b(function);
    control.write(b, [&](const char *text, ValueId with) {
        if (asked == Asked::Query)
            return query(b, ir::testSample, {text}, {with, number(b, 2)}, 3)[1];
        if (asked == Asked::Object)
            return query(b, ir::testObject, {text}, {}, 2)[1];
        command(b, ir::testNote, {text}, {with, boolean(b, true)});
        return with;
    });
    b.finish();
    EXPECT_EQ(ir::verify(function), "") << ir::print(function);
    return function;
}

using Runner = std::function<void(const ir::Function &, const ShaderArgs &)>;

/// The interpreter and code at both widths of all levels that the machine has.
struct Runners {
    std::vector<std::pair<std::string, Runner>> of(const ir::Function &function) {
        std::vector<std::pair<std::string, Runner>> all{{"interpreter", ir::interpret}};
        for (auto &[name, jit] : jits) {
            const ShaderFunction code = jit->compile(function);
            EXPECT_TRUE(code) << diagnostics.text();
            if (code)
                all.emplace_back(
                    name, [code](const ir::Function &, const ShaderArgs &args) { code(&args); });
        }
        return all;
    }
    Runners() {
        using runtime::IsaLevel;
        for (auto [name, level] :
             {std::pair("v2", IsaLevel::V2), {"v3", IsaLevel::V3}, {"v4", IsaLevel::V4}})
            for (int width : {1, 16}) {
                if (!Jit::hostRuns(level))
                    continue;
                JitOptions options;
                options.level = level;
                options.width = width;
                options.useCache = false;
                jits.emplace_back(std::string(name) + " W = " + std::to_string(width),
                                  std::make_unique<Jit>(options, diagnostics));
            }
    }
    DiagnosticList diagnostics;
    std::vector<std::pair<std::string, std::unique_ptr<Jit>>> jits;
};

struct Batch : TestBatch {
    Batch(const ir::Function &function, int count, std::vector<std::uint16_t> mask, float uniform)
        : TestBatch(function, count, unsigned(count)) {
        active = std::move(mask);
        setSamples(3, 5);
        for (std::size_t i = 0; i < samples.Cl[0].size(); i += 1 + i % 3)
            for (auto &plane : samples.Cl)
                plane[i] = 0;
        for (auto &space : spaces)
            space[0] = uniform;
        for (int lane = 0; lane < padded(); ++lane)
            objectIndex[std::size_t(lane)] = lane % 2;
        objects.insert(objects.end(), objects.begin(), objects.end());
        uniform_ = uniform;
    }
    bool runs(int lane) const {
        return lane < count && (active.empty() || active[std::size_t(lane / 16)] >> lane % 16 & 1);
    }
    LaneInputs of(int lane) const {
        const auto at = std::size_t(lane);
        LaneInputs in{inputs[int(ShaderInput::P)][at], inputs[int(ShaderInput::P) + 1][at],
                      uniform_};
        for (int row = 0; row < samples.rows; ++row)
            in.light += samples.Cl[0][std::size_t(row * padded()) + at] != 0;
        return in;
    }

private:
    float uniform_;
};

struct Masks {
    int count;
    std::vector<std::uint16_t> active;
};
const Masks masks[] = {{1, {}},
                       {7, {}},
                       {16, {}},
                       {40, {}},
                       {40, {0x8001, 0, 0x00f0}},
                       {37, {0xbeef, 0x0100, 0xffff}}};

TEST(Services, ActiveLanesAreAskedAsOftenAsTheyComeThereAndNoOthers) {
    Runners runners;
    int asked = 0, notAsked = 0;
    for (const Control &control : controls())
        for (Asked kind : {Asked::Query, Asked::Object, Asked::Command}) {
            const ir::Function function = program(control, kind);
            for (const auto &[name, runner] : runners.of(function))
                for (const Masks &mask : masks)
                    for (float uniform : {-0.5f, 0.7f}) {
                        Batch batch(function, mask.count, mask.active, uniform);
                        ServiceLog log;
                        batch.services = ir::testServices(&log);
                        batch.run(function, runner);
                        const std::string what = std::string(control.name) + ", " + name + ", " +
                                                 std::to_string(mask.count) + " lanes";
                        std::size_t sum = 0;
                        for (const ir::ServiceUse &use : function.services)
                            for (int lane = 0; lane < batch.padded(); ++lane) {
                                const std::string &text =
                                    function.strings[std::size_t(use.texts[0])];
                                // What depends on nothing is asked once a region.
                                int expected =
                                    batch.runs(lane) ? control.times(batch.of(lane), text) : 0;
                                sum += std::size_t(expected);
                                ASSERT_EQ(log.count(text, lane), expected)
                                    << what << ", \"" << text << "\" by lane " << lane;
                                ++(expected ? asked : notAsked);
                            }
                        ASSERT_EQ(log.lanes.size(), sum) << what;
                        for (int lanes : log.asking)
                            ASSERT_GT(lanes, 0) << what;
                    }
        }
    EXPECT_GT(asked, 1000);
    EXPECT_GT(notAsked, 1000);
}

/// Operands and answers, not only who asks.
TEST(Services, CodeAsksAndIsAnsweredAsTheInterpreter) {
    Runners runners;
    for (const Control &control : controls())
        for (Asked kind : {Asked::Query, Asked::Object, Asked::Command}) {
            const ir::Function function = program(control, kind);
            std::map<int, std::pair<ServiceLog, std::vector<TestBatch::Plane>>> expected;
            for (const auto &[name, runner] : runners.of(function))
                for (const Masks &mask : masks) {
                    Batch batch(function, mask.count, mask.active, 0.7f);
                    ServiceLog log;
                    batch.services = ir::testServices(&log);
                    const auto outputs = batch.run(function, runner, -3);
                    const auto [known, isFirst] =
                        expected.try_emplace(int(&mask - masks), log, outputs);
                    if (isFirst)
                        continue;
                    EXPECT_EQ(log.lanes, known->second.first.lanes) << control.name << name;
                    EXPECT_EQ(outputs, known->second.second) << control.name << ", " << name;
                }
        }
}

TEST(Services, ABlockAsksOnceForAllOfItsLanes) {
    Runners runners;
    const ir::Function function = program(controls()[0], Asked::Query);
    for (const auto &[name, runner] : runners.of(function)) {
        const int width = !name.ends_with("16")    ? 1
                          : name.starts_with("v2") ? 4
                          : name.starts_with("v3") ? 8
                                                   : 16;
        Batch batch(function, 48, {0xffff, 0, 0x8001}, 1);
        ServiceLog log;
        batch.services = ir::testServices(&log);
        batch.run(function, runner);
        EXPECT_EQ(log.widths.size(), std::size_t(16 / width + std::min(2, 16 / width))) << name;
        for (int lanes : log.widths)
            EXPECT_EQ(lanes, width) << name;
    }
}

/// What all lanes ask alike is asked once a block, under conditions too, in the name of one of the
/// lanes that ask.
TEST(Services, UniformQueriesAreAskedOnceABlockIfAnyLaneAsks) {
    Runners runners;
    for (bool conditional : {false, true}) {
        ir::Function function;
        Builder b(function);
        const auto ask = [&] {
            return query(b, ir::testSample, {"u"}, {uniform(b), number(b, 3)}, 1)[0];
        };
        result(b, conditional ? choose(b, isNegative(b, x(b)), ask, [&] { return number(b, -1); })
                              : ask());
        b.finish();
        ASSERT_EQ(ir::verify(function), "");
        for (const auto &[name, runner] : runners.of(function)) {
            Batch batch(function, 48, {0xfffe, 0, 0x0f00}, 0.5f);
            const auto asks = [&](int lane) {
                return batch.runs(lane) && (!conditional || batch.of(lane).x < 0);
            };
            ServiceLog log;
            batch.services = ir::testServices(&log);
            const auto outputs = batch.run(function, runner);
            const int width = !name.ends_with("16")    ? 1
                              : name.starts_with("v2") ? 4
                              : name.starts_with("v3") ? 8
                                                       : 16;
            std::size_t blocks = 0;
            for (int first = 0; first < 48; first += width) {
                bool any = false;
                for (int lane = first; lane < first + width; ++lane)
                    any |= asks(lane);
                blocks += any;
            }
            EXPECT_EQ(log.widths.size(), blocks) << name;
            for (const ir::LaneAsked &asked : log.lanes)
                EXPECT_TRUE(asks(asked.lane)) << name << " lane " << asked.lane;
            for (int lane = 0; lane < 48; ++lane)
                if (asks(lane)) {
                    EXPECT_EQ(outputs[0][std::size_t(lane)], 3.25f) << name;
                }
        }
    }
}

TEST(Services, OnlyEqualQueriesWhereTheyAreVisibleAreShared) {
    ir::Function function;
    Builder b(function);
    const auto ask = [&](const char *text, ValueId with) {
        return query(b, ir::testSample, {text}, {with, with}, 1)[0];
    };
    const auto note = [&] { command(b, ir::testNote, {"note"}, {x(b)}); };
    const ValueId first = ask("a", x(b));
    EXPECT_EQ(ask("a", x(b)), first);
    EXPECT_NE(ask("b", x(b)), first);
    EXPECT_NE(ask("a", y(b)), first);
    EXPECT_NE(query(b, ir::testSample, {"a"}, {x(b), x(b)}, 2)[0], first);
    note();
    note();
    ValueId sides[2];
    for (ValueId &side : sides)
        ifThen(b, isNegative(b, x(b)), [&] {
            EXPECT_EQ(ask("a", x(b)), first);
            side = ask("c", x(b));
        });
    EXPECT_NE(sides[0], sides[1]);
    EXPECT_NE(ask("c", x(b)), sides[0]);
    b.finish();
    Batch batch(function, 16, {}, 0);
    ServiceLog log;
    batch.services = ir::testServices(&log);
    batch.run(function, ir::interpret);
    EXPECT_EQ(log.count("note", 3), 2);
}

/// A constant under a condition, else what the lane's parameter block says; and nothing where its
/// number is that of no string.
TEST(Services, NamesMayBeChosenAtRunTime) {
    Runners runners;
    ir::Function function;
    function.parameters = {{"name", 0}};
    Builder b(function);
    const ValueId given = unary(b, ir::Op::StringFromFloat, parameter(b, 0));
    const ValueId name = select(b, isNegative(b, x(b)), text(b, "constant"), given);
    result(b, queryNamed(b, ir::testSample, name, {}, {x(b), y(b)}, 2)[1]);
    command(b, ir::testNote, {"printed"}, {given});
    b.finish();
    ASSERT_EQ(ir::verify(function), "");
    const char *const strings[] = {"zero", "one", "two"};
    ServiceLog first;
    for (const auto &[runner, run] : runners.of(function)) {
        Batch batch(function, 40, {0xffff, 0x0ff0, 0x00f1}, 0);
        for (int lane = 0; lane < batch.padded(); ++lane)
            batch.parameters[std::size_t(lane)] = float(lane % 5) - 1;
        ServiceLog log;
        batch.services = ir::testServices(&log);
        batch.services.strings = {strings, 3};
        batch.run(function, run);
        for (int lane = 0; lane < 40; ++lane) {
            const int number = lane % 5 - 1;
            const std::string expected = batch.of(lane).x < 0        ? "constant"
                                         : number < 0 || number >= 3 ? ""
                                                                     : strings[number];
            EXPECT_EQ(log.count(expected, lane), batch.runs(lane)) << runner << ", lane " << lane;
        }
        std::erase_if(log.lanes,
                      [](const ir::LaneAsked &asked) { return asked.service != "sample"; });
        first.lanes = first.lanes.empty() ? log.lanes : first.lanes;
        EXPECT_EQ(log.lanes, first.lanes) << runner;
    }
}

struct Told {
    std::vector<std::string> all;
    static void note(void *told, const char *service, const char *file, std::int32_t line) {
        static_cast<Told *>(told)->all.push_back(std::string(service) + " " + file + ":" +
                                                 std::to_string(line));
    }
};

TEST(Services, AnAbsentServiceGivesZerosAndSaysSo) {
    Runners runners;
    ir::Function function;
    Builder b(function);
    b.setFile(ir::intern(function.files, "a.sl"));
    b.setLine(7);
    result(b, query(b, ir::testSample, {"a"}, {x(b), y(b)}, 2)[1]);
    b.finish();
    for (const auto &[name, runner] : runners.of(function))
        for (bool hasTable : {false, true}) {
            Batch batch(function, 16, {}, 0);
            Told told;
            batch.services = {};
            batch.callbacks.context = &told;
            batch.callbacks.serviceAbsent = Told::note;
            const Runner &run = runner;
            const auto outputs =
                batch.run(function, [&](const ir::Function &text, const ShaderArgs &given) {
                    ShaderArgs args = given;
                    args.services = hasTable ? args.services : nullptr;
                    run(text, args);
                });
            EXPECT_EQ(outputs[0], TestBatch::Plane(16, 0.0f)) << name;
            ASSERT_FALSE(told.all.empty()) << name;
            EXPECT_EQ(told.all[0], "sample a.sl:7") << name;
        }
}

} // namespace
} // namespace candela
