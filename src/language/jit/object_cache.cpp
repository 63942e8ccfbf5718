// SPDX-License-Identifier: Apache-2.0
#include "language/jit/object_cache.h"

#include "foundation/base/hash.h"
#include "foundation/base/whole_file.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace candela {

namespace fs = std::filesystem;

static constexpr std::string_view extension = ".object";

/// Of the bytes as the key's: one key's object is not another's.
static std::string checksum(const std::string &key, std::string_view bytes) {
    ContentHash hash;
    hash.add(std::uint64_t(key.size()));
    hash.add(key);
    hash.add(bytes);
    return hash.text();
}

static std::string nameOf(const std::string &key) { return key + std::string(extension); }

ObjectCache::ObjectCache(fs::path folder, std::uintmax_t limit)
    : folder_(std::move(folder)), limit_(limit) {}

ObjectCache::~ObjectCache() {
    if (directory_ >= 0)
        close(directory_);
}

fs::path ObjectCache::defaultFolder() {
    const auto variable = [](const char *name) {
        const char *value = std::getenv(name);
        return fs::path(value ? value : "");
    };
    if (const fs::path own = variable("CANDELA_CACHE"); !own.empty())
        return own;
    if (const fs::path shared = variable("XDG_CACHE_HOME"); !shared.empty())
        return shared / "candela";
    if (const fs::path home = variable("HOME"); !home.empty())
        return home / ".cache" / "candela";
    return {};
}

std::string ObjectCache::takeObjection() {
    std::lock_guard lock(mutex_);
    return std::exchange(objection_, {});
}

bool ObjectCache::isOurs(int file, const fs::path &path) {
    struct stat facts {};
    if (fstat(file, &facts) != 0)
        return false;
    const char *flaw = facts.st_uid != geteuid()             ? "belongs to another user"
                       : facts.st_mode & (S_IWGRP | S_IWOTH) ? "can be written by others"
                                                             : nullptr;
    if (flaw)
        objection_ = path.string() + " " + flaw + ", so the shader cache does without it";
    return !flaw;
}

bool ObjectCache::open() {
    if (directory_ >= 0 || folder_.empty())
        return directory_ >= 0;
    const int directory = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0)
        return false;
    if (isOurs(directory, folder_)) {
        directory_ = directory;
        return true;
    }
    close(directory);
    folder_.clear();
    return false;
}

std::optional<std::string> ObjectCache::load(const std::string &key) {
    std::optional<std::string> bytes;
    {
        std::lock_guard lock(mutex_);
        if (!open())
            return std::nullopt;
        // Links would lead out of the folder; a pipe would be waited for.
        const int file =
            openat(directory_, nameOf(key).c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (file < 0)
            return std::nullopt;
        struct stat facts {};
        if (isOurs(file, folder_ / nameOf(key)) && fstat(file, &facts) == 0 &&
            S_ISREG(facts.st_mode)) {
            std::string ignored;
            if (std::uintmax_t(facts.st_size) <= limit_)
                bytes = readAll(file, ignored, limit_);
            else // Nothing that was stored, and not worth reading.
                unlinkat(directory_, nameOf(key).c_str(), 0);
        }
        close(file);
    }
    const std::size_t line = bytes ? bytes->find('\n') : std::string::npos;
    if (line == std::string::npos)
        return std::nullopt;
    const std::string sum = bytes->substr(0, line);
    bytes->erase(0, line + 1);
    if (bytes->empty() || checksum(key, *bytes) != sum)
        return std::nullopt;
    return bytes;
}

static bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t done = write(file, bytes.data(), bytes.size());
        if (done < 0 && errno != EINTR)
            return false;
        bytes.remove_prefix(done < 0 ? 0 : std::size_t(done));
    }
    return true;
}

/// A file of its own for each writer, whatever a process of that number has left.
static int createPart(int directory, const std::string &name) {
    constexpr int flags = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    int file = openat(directory, name.c_str(), flags, 0600);
    if (file < 0 && errno == EEXIST && unlinkat(directory, name.c_str(), 0) == 0)
        file = openat(directory, name.c_str(), flags, 0600);
    return file;
}

static void createFolder(const fs::path &folder) {
    std::error_code error;
    if (folder.has_parent_path())
        fs::create_directories(folder.parent_path(), error);
    mkdir(folder.c_str(), 0700);
}

void ObjectCache::store(const std::string &key, std::string_view bytes) {
    std::lock_guard lock(mutex_);
    if (folder_.empty())
        return;
    if (directory_ < 0)
        createFolder(folder_);
    if (!open())
        return;
    static std::atomic<unsigned> number{0};
    const std::string part =
        key + "." + std::to_string(getpid()) + "." + std::to_string(number++) + ".part";
    const int file = createPart(directory_, part);
    if (file < 0)
        return;
    const bool whole = writeAll(file, checksum(key, bytes) + "\n") && writeAll(file, bytes);
    // The rename makes the whole file appear at once.
    if (close(file) != 0 || !whole ||
        renameat(directory_, part.c_str(), directory_, nameOf(key).c_str()) != 0) {
        unlinkat(directory_, part.c_str(), 0);
        return;
    }
    written_ += bytes.size();
    // Measuring a folder costs more than a store, so it is done now and then.
    if (!measured_ || written_ > limit_ / 16)
        evict();
}

void ObjectCache::remove(const std::string &key) {
    std::lock_guard lock(mutex_);
    if (open())
        unlinkat(directory_, nameOf(key).c_str(), 0);
}

void ObjectCache::evict() {
    struct Entry {
        fs::file_time_type written;
        std::string name;
        std::uintmax_t size;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        if (it->path().extension() != extension || it->is_symlink())
            continue;
        std::error_code gone;
        Entry entry{it->last_write_time(gone), it->path().filename(), it->file_size(gone)};
        if (gone)
            continue;
        if (entry.size > limit_) { // Alone too large: no reason for others to go.
            unlinkat(directory_, entry.name.c_str(), 0);
            continue;
        }
        total += entry.size;
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
        return a.written != b.written ? a.written < b.written : a.name < b.name;
    });
    for (const Entry &entry : entries) {
        if (total <= limit_)
            break;
        unlinkat(directory_, entry.name.c_str(), 0);
        total -= entry.size;
    }
    measured_ = true;
    written_ = 0;
}

} // namespace candela
