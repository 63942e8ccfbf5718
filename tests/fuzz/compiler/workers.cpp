// SPDX-License-Identifier: Apache-2.0
#include "workers.h"

#include "process_limits.h"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace candela::fuzz {

namespace {

constexpr int inputsAProcess = 200; // Code that was generated stays until its process ends.
constexpr int problemStatus = 3, memoryStatus = 4;
constexpr std::size_t mostSaid = 3000;

/// What a process tells its parent, also when it dies.
struct Slot {
    std::uint64_t input;
    Stage stage;
    char detail[100];
    char problem[4000];
    std::size_t textSize;
    char text[1 << 20];
};

void copyText(const std::string &from, char *to, std::size_t size) {
    const std::size_t length = std::min(from.size(), size - 1);
    std::memcpy(to, from.data(), length);
    to[length] = '\0';
}

/// Where the processes meet.
struct SharedMemory {
    std::atomic<std::uint64_t> next, end;
    Tally tally;
};

template <typename Type> Type *share(std::size_t count) {
    void *memory = mmap(nullptr, count * sizeof(Type), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        throw std::bad_alloc();
    std::uninitialized_value_construct_n(static_cast<Type *>(memory), count);
    return static_cast<Type *>(memory);
}

class WorkerMonitor : public Monitor {
public:
    WorkerMonitor(Slot &slot, Tally &tally, Limits limits)
        : slot_(slot), tally_(tally), limits_(limits) {}

    void begin(std::uint64_t input) {
        slot_.input = input;
        show({});
    }
    void show(const std::string &text) override {
        slot_.textSize = std::min(text.size(), sizeof slot_.text);
        std::memcpy(slot_.text, text.data(), slot_.textSize);
        slot_.stage = Stage::Front;
        slot_.detail[0] = '\0';
        allowMemory(limits_.mebibytes);
        allowSeconds(limits_.seconds);
    }
    void end() { allowSeconds(0); }

    /// To run what the shader says does not take from the compiler's time.
    void enter(Stage stage, const std::string &detail) override {
        const auto runs = [](Stage s) { return s == Stage::Interpret || s == Stage::Execute; };
        const double own = limits_.interpretSeconds * (stage == Stage::Interpret ? 1 : 20);
        if (runs(stage) && runs(slot_.stage))
            allowSeconds(own);
        else if (runs(stage))
            left_ = allowSeconds(own);
        else if (runs(slot_.stage))
            allowSeconds(std::max(left_, 1e-3));
        slot_.stage = stage;
        copyText(detail, slot_.detail, sizeof slot_.detail);
    }
    Tally &tally() override { return tally_; }

private:
    Slot &slot_;
    Tally &tally_;
    Limits limits_;
    double left_ = 0; ///< Of the compiler's seconds.
};

[[noreturn]] void work(const Subject &subject, Slot &slot, SharedMemory &shared, int said,
                       Limits limits) {
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    std::set_new_handler([] { _exit(memoryStatus); });
    WorkerMonitor monitor(slot, shared.tally, limits);
    for (int n = 0; n < inputsAProcess; ++n) {
        const std::uint64_t input = shared.next++;
        if (input >= shared.end)
            break;
        ++shared.tally.tried;
        monitor.begin(input);
        std::string problem = subject(input, monitor);
        monitor.end();
        std::fflush(nullptr);
        if (problem.empty() && lseek(said, 0, SEEK_END) > 0)
            problem = "writes to the terminal";
        if (!problem.empty()) {
            copyText(problem, slot.problem, sizeof slot.problem);
            _exit(problemStatus);
        }
    }
    _exit(0);
}

/// What a process has written: the sanitizer's report if there is one, else the end.
std::string readSaid(int file) {
    const off_t size = lseek(file, 0, SEEK_END);
    std::string text(std::size_t(std::clamp<off_t>(size, 0, 1 << 20)), '\0');
    if (pread(file, text.data(), text.size(), size - off_t(text.size())) < 0)
        return {};
    for (const char *mark : {"==ERROR", "runtime error:"})
        if (const std::size_t at = text.find(mark); at != std::string::npos)
            return text.substr(text.rfind('\n', at) + 1, mostSaid);
    return text.substr(text.size() - std::min(text.size(), mostSaid));
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

} // namespace

const char *nameOf(Stage stage) {
    constexpr const char *names[] = {"front",     "lower",    "facts",  "slice",
                                     "interpret", "generate", "execute"};
    return names[int(stage)];
}

struct Workers::State {
    State(Subject subject, Limits limits, std::size_t processes)
        : subject(std::move(subject)), limits(limits), shared(share<SharedMemory>(1)),
          slots(share<Slot>(processes)), processes(processes, 0) {
        for (std::size_t n = 0; n < processes; ++n)
            said.push_back(memfd_create("said", MFD_CLOEXEC));
    }
    ~State() {
        std::ranges::for_each(said, close);
        munmap(shared, sizeof(SharedMemory));
        munmap(slots, said.size() * sizeof(Slot));
    }
    State(const State &) = delete;
    State &operator=(const State &) = delete;

    Subject subject;
    Limits limits;
    std::vector<int> said; ///< A file without a name for each process.
    SharedMemory *shared;
    Slot *slots;
    std::vector<pid_t> processes; ///< 0: none.

    void start(std::size_t which) {
        slots[which].stage = {};
        slots[which].problem[0] = '\0';
        std::fflush(nullptr);
        if (ftruncate(said[which], 0) != 0 || lseek(said[which], 0, SEEK_SET) != 0 ||
            (processes[which] = fork()) < 0)
            throw std::system_error(errno, std::generic_category(), "a process for inputs");
        if (processes[which] == 0)
            work(subject, slots[which], *shared, said[which], limits);
    }

    /// What the end of a process means; nothing if it is no failure.
    std::string judge(const Slot &slot, int status, int file) {
        const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
        if (signal == SIGPROF || signal == SIGALRM) {
            if (slot.stage != Stage::Interpret)
                return "takes more than " +
                       number(limits.seconds * (slot.stage == Stage::Execute ? 20 : 1)) + " s";
            ++shared->tally.endless;
            return {};
        }
        if (code == problemStatus)
            return slot.problem + ("\n" + readSaid(file));
        if (code == memoryStatus)
            return "takes more than " + std::to_string(limits.mebibytes) + " MiB";
        if (signal || code)
            return (signal ? "ends by signal " : "exits with ") +
                   std::to_string(signal ? signal : code) + "\n" + readSaid(file);
        return {};
    }
};

Workers::Workers(Subject subject, Limits limits, int processes)
    : state_(std::make_unique<State>(std::move(subject), limits, std::size_t(processes))) {}

Workers::~Workers() = default;

const Tally &Workers::tally() const { return state_->shared->tally; }

void Workers::run(std::uint64_t first, std::uint64_t count,
                  const std::function<void(const Failure &)> &report) {
    State &state = *state_;
    state.shared->next = first;
    state.shared->end = first + count;
    for (std::size_t n = 0; n < state.processes.size(); ++n)
        state.start(n);
    int status = 0;
    while (true) {
        const pid_t ended = wait(&status);
        const auto which = std::ranges::find(state.processes, ended);
        if (ended < 0)
            return;
        if (which == state.processes.end())
            continue;
        const auto n = std::size_t(which - state.processes.begin());
        const Slot &slot = state.slots[n];
        *which = 0;
        if (const std::string problem = state.judge(slot, status, state.said[n]); !problem.empty())
            report({slot.input, slot.stage, slot.detail, {slot.text, slot.textSize}, problem});
        if (state.shared->next < state.shared->end)
            state.start(n);
    }
}

Failure tryAlone(const Subject &subject, Limits limits, std::uint64_t input) {
    Failure result;
    Workers one(subject, limits, 1);
    one.run(input, 1, [&](const Failure &failure) { result = failure; });
    return result;
}

} // namespace candela::fuzz
