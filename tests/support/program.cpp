// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program.h"

#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace candela::test {

namespace {

constexpr int couldNotStart = 127;

void redirect(int stream, const std::string &path, int flags) {
    int file = open(path.c_str(), flags, 0644);
    if (file < 0 || dup2(file, stream) < 0)
        _exit(couldNotStart);
    close(file);
}

std::vector<std::string> launcher() {
    const char *text = std::getenv("CANDELA_LAUNCHER");
    std::istringstream stream(text ? text : "");
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

/// In the child: never returns.
[[noreturn]] void become(std::vector<char *> &arguments, const RunSettings &settings,
                         const ScratchFolder &said) {
    redirect(STDOUT_FILENO, said.path("out"), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDERR_FILENO, said.path("err"), O_WRONLY | O_CREAT | O_TRUNC);
    redirect(STDIN_FILENO, settings.input.empty() ? "/dev/null" : settings.input, O_RDONLY);
    if (!settings.folder.empty() && chdir(settings.folder.c_str()) != 0)
        _exit(couldNotStart);
    if (settings.fileSizeLimit >= 0) {
        std::signal(SIGXFSZ, SIG_DFL); // As shells leave it: what does not ignore it is ended.
        rlimit limit{rlim_t(settings.fileSizeLimit), rlim_t(settings.fileSizeLimit)};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (settings.memoryLimit >= 0) {
        rlimit limit{rlim_t(settings.memoryLimit), rlim_t(settings.memoryLimit)};
        setrlimit(RLIMIT_AS, &limit);
    }
    if (settings.sentSignal != 0)
        std::signal(settings.sentSignal, SIG_DFL); // Whatever the tests' shell ignores.
    alarm(unsigned(
        std::ceil(settings.secondsAllowed * timeScale()))); // outlives exec: what hangs is ended
    execvp(arguments[0], arguments.data());
    _exit(couldNotStart);
}

} // namespace

std::string Outcome::text() const {
    std::string how = signal ? "ended by signal " + std::to_string(signal)
                             : "exit status " + std::to_string(status);
    return how + "\nstdout:\n" + out + "\nstderr:\n" + err;
}

std::string Outcome::errBesidesLight() const {
    constexpr const char *ofLight[] = {"the picture is black: ", " shines on nothing, ",
                                       " is shut out: ", " adds light of its own, "};
    std::istringstream lines(err);
    std::string rest;
    for (std::string line; std::getline(lines, line);)
        if (std::ranges::none_of(ofLight,
                                 [&](const char *words) { return line.find(words) != line.npos; }))
            rest += line + "\n";
    return rest;
}

std::string candelaProgram() { return CANDELA_BINARY_DIR "/bin/candela"; }

double timeScale() {
    const char *scale = std::getenv("CANDELA_TIME_SCALE");
    return scale ? std::max(1.0, std::atof(scale)) : 1;
}

Outcome runCandela(const std::vector<std::string> &arguments, const RunSettings &settings) {
    ScratchFolder said;
    std::vector<std::string> words = launcher();
    words.push_back(settings.program.empty() ? candelaProgram() : settings.program);
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char *> pointers;
    for (std::string &word : words)
        pointers.push_back(word.data());
    pointers.push_back(nullptr);

    pid_t child = fork();
    if (child == 0)
        become(pointers, settings, said);
    if (settings.sentSignal != 0 && child > 0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(settings.signalAfter));
        kill(child, settings.sentSignal); // One that has ended is still to be waited for.
    }
    int status = 0;
    Outcome outcome;
    if (child < 0 || waitpid(child, &status, 0) != child)
        return outcome;
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    outcome.out = said.read("out");
    outcome.err = said.read("err");
    return outcome;
}

} // namespace candela::test
