// SPDX-License-Identifier: Apache-2.0
// Tells a shader's text anew, under one or several hypotheses about the light at once, keeping
// only some stages. All questions are told by it.
#pragma once

#include "language/ir/builder.h"
#include "language/ir/cones.h"
#include "language/ir/dependence.h"

#include <map>
#include <optional>

namespace candela::ir {

/// What the light requests, ambient() and irradiance() answer.
struct Hypothesis {
    enum class Light {
        None,    ///< Nothing: loops don't run, answers are black.
        Given,   ///< As the caller gives it.
        Sampled, ///< Unit light as ShaderArgs::answeredRequest has it, from Input sampleL.
        Probed,  ///< A unit contribution through cone `probe` alone, without asking for light.
    };
    Light light = Light::None;
    bool ambient = false; ///< ambient() and irradiance() as given; else black.
    const Cone *probe = nullptr;
};

struct Telling {
    Stage first = Stage::Surface, last = Stage::Response;
    /// Stages are told apart: what is earlier than `first` comes from the frame or is recomputed
    /// if it costs at most `recomputeCost` operations. Otherwise all is told in place.
    bool framed = false;
    bool fused = false; ///< Surface and View count as one stage.
    int recomputeCost = 1;
    bool prints = false;
    /// Loops of known count are unrolled where they hold light requests or are small.
    bool unrolls = false;
    /// Every instruction that asks for light gets a request of its own, in program order.
    bool renumbers = false;
    /// Values to save, with their slots. Without it loads number their slots by ValueId.
    const std::map<ValueId, int> *slots = nullptr;
    /// Cones to state in outputs, where the light loops stand.
    const std::vector<Cone> *cones = nullptr;
    /// Culls of classic loops, by request.
    const std::vector<Cull> *culls = nullptr;
};

class Specializer {
public:
    Specializer(const Function &text, const Dependence &, Builder &, std::vector<Hypothesis>,
                const Telling &);

    void run() { walk(text_.body, {telling_.first, telling_.last}); }

    /// After run(): what the text's last Output to a slot wrote; nothing if there is none.
    std::optional<ValueId> output(int hypothesis, const std::string &slot, int component);
    /// The same under hypothesis 0, but nothing if light does not reach it.
    std::optional<ValueId> responseOutput(const std::string &slot, int component);
    /// The new name of a value of the text.
    ValueId value(int hypothesis, ValueId);
    Triple triple(int hypothesis, const Triple &);

private:
    struct Range {
        Stage first, last;
        bool has(Stage s) const { return first <= s && s <= last; }
    };

    Stage stageOf(Stage) const;
    Stage stageOf(ValueId v) const { return stageOf(dependence_.stage[v]); }
    bool responds(ValueId v) const { return dependence_.stage[v] == Stage::Response; }
    Values valuesOf(int hypothesis, const Values &);
    ValueId fetch(int hypothesis, ValueId);
    int cost(ValueId) const;
    void assign(int hypothesis, ValueId old, ValueId now) { maps_[hypothesis][old] = now; }
    void assignShared(ValueId old, ValueId now);
    void save(ValueId old, ValueId now);
    std::vector<std::vector<int>> groupsBy(ValueId condition);
    int arrayFor(int hypothesis, int array);

    void walk(const Region &, Range);
    void walk(const Instruction &, Range);
    void walkPlain(const Instruction &, Range);
    void walkPrint(const Instruction &);
    void walkIf(const Instruction &, Range);
    void emitIf(const Instruction &, Range results, Range content);
    void walkLoop(const Instruction &, Range);
    void emitLoop(const Instruction &, Range);
    bool unrollLoop(const Instruction &, Range);
    int requestFor(int request);
    bool wantsLoop(const Instruction &, Range) const;
    bool storesIn(const Region &, Range) const;
    void walkAnswer(const Instruction &, Range);
    void walkLightLoop(const Instruction &, Range);
    Values lightLoopUnder(int hypothesis, const Instruction &);
    Values givenLoop(int hypothesis, const Instruction &);
    Values sampledLoop(int hypothesis, const Instruction &);
    Values probedLoop(int hypothesis, const Instruction &);
    ValueId sampleReaches(int hypothesis, const Instruction &);
    void stateCones(const Instruction &);

    const Function &text_;
    const Dependence &dependence_;
    Builder &b_;
    std::vector<Hypothesis> hypotheses_;
    Telling telling_;
    std::vector<std::vector<ValueId>> maps_; ///< By hypothesis and old value.
    std::vector<int> active_;                ///< The hypotheses being told.
    int loopDepth_ = 0;
    int retelling_ = 0;                         ///< > 0: what is told was told, and saved, before.
    std::map<std::pair<int, int>, int> arrays_; ///< (hypothesis or -1, array) to new array.
    std::map<std::pair<std::string, int>, ValueId> outputs_;
};

} // namespace candela::ir
