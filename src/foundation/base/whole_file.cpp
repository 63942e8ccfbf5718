// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/whole_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>

namespace candela {

namespace {

namespace fs = std::filesystem;

bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        bytes.remove_prefix(std::size_t(written));
    }
    return true;
}

/// Makes a new file beside `target` with the permissions an ordinary new file gets; -1 and errno
/// if it cannot. The name is unique to the process and the call.
int openTemporary(const fs::path &target, std::string &name) {
    static std::atomic<unsigned> counter{0};
    constexpr int attempts = 100;
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    const std::string stem =
        "." + target.filename().string().substr(0, 100) + "." + std::to_string(::getpid()) + ".";
    for (int i = 0; i < attempts; ++i) {
        name = (folder / (stem + std::to_string(counter++) + ".tmp")).string();
        const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0 || errno != EEXIST)
            return file;
    }
    return -1;
}

/// A file under its temporary name, and what it is to become.
struct OpenFile {
    int file;
    std::string temporary;
    fs::path target;
};

std::optional<OpenFile> openFor(const std::string &path, std::string &problem) {
    std::error_code error;
    OpenFile open{-1, {}, path};
    if (fs::is_symlink(open.target, error)) // Not the link, but what it leads to.
        open.target = fs::weakly_canonical(open.target, error);
    problem = "cannot write " + path + ": ";
    if (fs::exists(open.target, error) && !fs::is_regular_file(open.target, error)) {
        problem += "it is there and not a regular file";
        return std::nullopt;
    }
    open.file = openTemporary(open.target, open.temporary);
    if (open.file < 0) {
        problem += std::strerror(errno);
        return std::nullopt;
    }
    problem.clear();
    return open;
}

bool writeAndClose(int file, std::string_view bytes) {
    const bool written = writeAll(file, bytes);
    const int reason = errno;
    const bool closed = ::close(file) == 0;
    if (!written)
        errno = reason;
    return written && closed;
}

} // namespace

bool writeWholeFile(const std::string &path, std::string_view bytes, std::string &problem) {
    std::optional<OpenFile> open = openFor(path, problem);
    if (!open)
        return false;
    if (!writeAndClose(open->file, bytes) ||
        std::rename(open->temporary.c_str(), open->target.c_str()) != 0) {
        problem = "cannot write " + path + ": " + std::strerror(errno);
        ::unlink(open->temporary.c_str());
        return false;
    }
    return true;
}

bool canWriteFile(const std::string &path, std::string &problem) {
    std::optional<OpenFile> open = openFor(path, problem);
    if (!open)
        return false;
    ::close(open->file);
    ::unlink(open->temporary.c_str());
    return true;
}

std::optional<std::string> readAll(int file, std::string &problem, std::uintmax_t limit) {
    constexpr std::size_t most = std::size_t(1) << 20, least = std::size_t(1) << 14;
    std::string bytes;
    for (std::size_t used = 0;;) {
        // One byte beyond the limit tells a file that ends there from one that is longer.
        const std::uintmax_t room = limit - used < most ? limit - used + 1 : most;
        bytes.resize(used + std::min<std::uintmax_t>(room, std::max(used, least)));
        const ssize_t got = ::read(file, bytes.data() + used, bytes.size() - used);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0) {
            problem = std::strerror(errno);
            return std::nullopt;
        }
        used += std::size_t(got);
        if (used > limit) {
            problem = "it has more than " + std::to_string(limit) + " bytes";
            return std::nullopt;
        }
        if (got == 0) {
            bytes.resize(used);
            return bytes;
        }
    }
}

std::optional<std::string> readWholeFile(const std::string &path, std::string &problem,
                                         std::uintmax_t limit) {
    // Without waiting for somebody to write into a pipe.
    const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    struct stat facts {};
    std::optional<std::string> bytes;
    if (file < 0 || ::fstat(file, &facts) != 0)
        problem = std::strerror(errno);
    else if (!S_ISREG(facts.st_mode))
        problem = "it is not a regular file";
    else
        bytes = readAll(file, problem, limit);
    if (file >= 0)
        ::close(file);
    if (!bytes)
        problem = "cannot read " + path + ": " + problem;
    return bytes;
}

} // namespace candela
