// SPDX-License-Identifier: Apache-2.0
#include "image/whole_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace candela {

namespace {

namespace fs = std::filesystem;

/// Writing beyond RLIMIT_FSIZE raises SIGXFSZ, which would end the process with other pictures
/// unwritten. While this lives the signal is held back, and taken away if it came, so that write()
/// just fails with EFBIG.
class FileSizeSignalHeld {
public:
    FileSizeSignalHeld() {
        sigemptyset(&signal_);
        sigaddset(&signal_, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &signal_, &before_);
    }
    ~FileSizeSignalHeld() {
        const int reason = errno; // Of the write, which is to be reported.
        const timespec now{};
        while (sigtimedwait(&signal_, nullptr, &now) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
        errno = reason;
    }
    FileSizeSignalHeld(const FileSizeSignalHeld &) = delete;

private:
    sigset_t signal_, before_;
};

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
    const FileSizeSignalHeld held;
    const bool written = writeAll(file, bytes);
    const int reason = errno;
    const bool closed = ::close(file) == 0;
    if (!written)
        errno = reason;
    return written && closed;
}

bool liesWithin(const fs::path &path, const fs::path &folder) {
    const auto [end, unused] =
        std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    return end == folder.end();
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

std::optional<std::string> readWholeFile(const std::string &path, std::string &problem) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        problem = "cannot read " + path + ": " +
                  (fs::exists(path, error) ? "not a regular file" : "no such file");
        return std::nullopt;
    }
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    if (!stream || stream.bad()) {
        if (fs::file_size(path, error) == 0 && !error)
            return std::string();
        problem = "cannot read " + path + ": " + std::strerror(errno);
        return std::nullopt;
    }
    return content.str();
}

std::optional<std::string> outputPath(const std::string &name, const std::string &directory,
                                      bool allowOutside, std::string &problem) {
    const auto fail = [&](const std::string &what) {
        problem = "cannot write " + name + ": " + what;
        return std::nullopt;
    };
    if (name.empty() || name.find('\0') != std::string::npos)
        return fail("a display needs a file name");
    std::error_code error;
    const fs::path folder = fs::absolute(directory.empty() ? "." : directory, error);
    const fs::path path = folder / name; // An absolute name stands for itself.
    const fs::path realFolder = fs::weakly_canonical(folder, error);
    if (error)
        return fail(error.message());
    const fs::path realPath = fs::weakly_canonical(path, error);
    if (error)
        return fail(error.message());
    if (!allowOutside && !liesWithin(realPath, realFolder))
        return fail("writes outside the output folder need --allow-programs");
    fs::create_directories(path.parent_path(), error);
    if (error)
        return fail("cannot make its folder " + path.parent_path().lexically_normal().string() +
                    ": " + error.message());
    return path.lexically_normal().string();
}

} // namespace candela
