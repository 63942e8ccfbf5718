// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/answering_program.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace candela {

namespace {

/// "0.5", "60"
std::string inSeconds(double seconds) {
    std::string text = std::to_string(seconds);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.'))
        text.pop_back();
    return text + (seconds == 1 ? " second" : " seconds");
}

/// A child with these as its standard input and output, first of a process group of its own.
int spawn(const std::vector<std::string> &words, int input, int output, pid_t &process) {
    std::vector<char *> arguments;
    for (const std::string &word : words)
        arguments.push_back(const_cast<char *>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE), sigaddset(&usual, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
    const int problem = posix_spawn(&process, words.front().c_str(), &actions, &attributes,
                                    arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return problem;
}

} // namespace

std::unique_ptr<AnsweringProgram> AnsweringProgram::start(const std::vector<std::string> &words,
                                                          const AnswerLimits &limits,
                                                          std::string &why) {
    // A socket, since a pipe that nobody reads any more would end this program, too.
    int toChild[2], fromChild[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, toChild) != 0) {
        why = std::strerror(errno);
        return nullptr;
    }
    if (pipe2(fromChild, O_CLOEXEC) != 0) {
        why = std::strerror(errno);
        close(toChild[0]), close(toChild[1]);
        return nullptr;
    }
    pid_t process = 0;
    const int problem = spawn(words, toChild[1], fromChild[1], process);
    close(toChild[1]), close(fromChild[1]);
    if (problem != 0) {
        why = std::strerror(problem);
        close(toChild[0]), close(fromChild[0]);
        return nullptr;
    }
    return std::unique_ptr<AnsweringProgram>(
        new AnsweringProgram(process, toChild[0], fromChild[0], limits));
}

AnsweringProgram::AnsweringProgram(pid_t process, int input, int output, const AnswerLimits &limits)
    : process_(process), input_(input), output_(output), limits_(limits), asked_(Clock::now()) {}

AnsweringProgram::~AnsweringProgram() {
    close(output_);
    if (input_ >= 0)
        close(input_);
    // Most end when their input does.
    if (!bad_)
        waitForEnd(0.2);
    kill(-process_, SIGKILL);
    int status = 0;
    waitpid(process_, &status, 0);
}

/// Leaves it to be waited for, so that its number stays its own.
bool AnsweringProgram::waitForEnd(double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    for (;;) {
        siginfo_t state{};
        if (waitid(P_PID, id_t(process_), &state, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            state.si_pid == process_)
            return true;
        if (Clock::now() >= end)
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

bool AnsweringProgram::wait(int file, short events, std::string &why) {
    for (;;) {
        const double passed = std::chrono::duration<double>(Clock::now() - asked_).count();
        const double left = std::min(limits_.secondsOfSilence, limits_.seconds - passed);
        pollfd ready{file, events, 0};
        const int count = left > 0 ? poll(&ready, 1, int(left * 1000) + 1) : 0;
        if (count > 0)
            return true;
        if (count < 0 && errno == EINTR)
            continue;
        why = left < limits_.secondsOfSilence
                  ? "it has not finished its answer in " + inSeconds(limits_.seconds)
                  : "it has said nothing for " + inSeconds(limits_.secondsOfSilence);
        return false;
    }
}

std::size_t AnsweringProgram::broken(std::string &failure, const std::string &how) {
    failure = how + "; it is ended, and not asked again";
    done_ = bad_ = true;
    return 0;
}

bool AnsweringProgram::ask(const std::string &line, std::string &why) {
    asked_ = Clock::now();
    bytes_ = 0;
    for (std::string_view rest = line; !rest.empty();) {
        std::string how;
        if (!wait(input_, POLLOUT, how)) {
            broken(why, how);
            return false;
        }
        const ssize_t count = send(input_, rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && (errno == EINTR || errno == EAGAIN))
            continue;
        if (count <= 0) {
            done_ = true;
            why = verdict();
            if (why.empty())
                why = "it takes no more lines";
            return false;
        }
        rest.remove_prefix(std::size_t(count));
    }
    return true;
}

std::size_t AnsweringProgram::read(char *to, std::size_t most, std::string &failure) {
    if (done_)
        return 0;
    std::string how;
    if (!wait(output_, POLLIN, how))
        return broken(failure, how);
    const ssize_t count = ::read(output_, to, most);
    if (count < 0)
        return errno == EINTR ? read(to, most, failure) : broken(failure, std::strerror(errno));
    done_ = count == 0;
    bytes_ += std::size_t(count);
    if (bytes_ > limits_.bytes)
        return broken(failure,
                      "its answer has more than " + std::to_string(limits_.bytes) + " bytes");
    return std::size_t(count);
}

std::string AnsweringProgram::verdict() {
    close(std::exchange(input_, -1));
    if (!waitForEnd(limits_.secondsOfSilence))
        return "it has closed its output and goes on";
    siginfo_t state{};
    waitid(P_PID, id_t(process_), &state, WEXITED | WNOHANG | WNOWAIT);
    if (state.si_code != CLD_EXITED)
        return "it was ended by signal " + std::to_string(state.si_status);
    return state.si_status == 0 ? ""
                                : "it ended with exit status " + std::to_string(state.si_status);
}

} // namespace candela
