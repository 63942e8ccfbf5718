// SPDX-License-Identifier: Apache-2.0
// Processes that try inputs one after the other, with limits on each: a crash ends one of them and
// still names its input.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace candela::fuzz {

/// What an input is going through.
enum class Stage : std::uint8_t {
    Front,     ///< Preprocessing, parsing, checking.
    Lower,     ///< To IR.
    Facts,     ///< What is known of the whole text; folding.
    Slice,     ///< To the function that answers a question.
    Interpret, ///< May take for ever, as the shader says: not a failure.
    Generate,  ///< Machine code.
    Execute,   ///< Machine code where the interpreter came to an end.
};
const char *nameOf(Stage);

/// Counted in all processes together.
struct Tally {
    std::atomic<std::uint64_t> tried, compiled, interpreted, compared, endless, numbers, finite;
};

struct Limits {
    double seconds = 2;          ///< Of the processor for all stages but these:
    double interpretSeconds = 1; ///< and 20 times as many to execute.
    std::size_t mebibytes = 500; ///< More memory than before the input.
};

/// What a process says of the input that it tries.
class Monitor {
public:
    virtual ~Monitor() = default;
    /// What is being tried from here on; limits count anew.
    virtual void show(const std::string &text) = 0;
    /// `detail` names the question or the like; it may be empty.
    virtual void enter(Stage, const std::string &detail) = 0;
    virtual Tally &tally() = 0;
};

/// Tries the input of that number; what is wrong, or nothing.
using Subject = std::function<std::string(std::uint64_t input, Monitor &)>;

struct Failure {
    std::uint64_t input = 0;
    Stage stage{};
    std::string detail;
    std::string text;    ///< As shown last.
    std::string problem; ///< Its first line is the same for inputs that fail alike.
};

class Workers {
public:
    Workers(Subject, Limits, int processes);
    ~Workers();

    /// Tries inputs first to first + count - 1, and tells of each failure as soon as it is there
    /// (where no other Workers may be started: they would wait for these processes).
    void run(std::uint64_t first, std::uint64_t count,
             const std::function<void(const Failure &)> &report);
    const Tally &tally() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The failure of a single input in a process of its own; nothing wrong: an empty problem.
Failure tryAlone(const Subject &, Limits, std::uint64_t input);

} // namespace candela::fuzz
