// SPDX-License-Identifier: Apache-2.0
#include "language/jit/object_cache.h"

#include "foundation/base/hash.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace candela {

namespace fs = std::filesystem;

static constexpr std::string_view extension = ".object";

static std::string checksum(std::string_view bytes) {
    ContentHash hash;
    hash.add(bytes);
    return hash.text();
}

ObjectCache::ObjectCache(fs::path folder, std::uintmax_t limit)
    : folder_(std::move(folder)), limit_(limit) {}

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

fs::path ObjectCache::fileOf(const std::string &key) const {
    return folder_ / (key + std::string(extension));
}

std::optional<std::string> ObjectCache::load(const std::string &key) const {
    if (folder_.empty())
        return std::nullopt;
    std::ifstream file(fileOf(key), std::ios::binary);
    if (!file)
        return std::nullopt;
    std::string sum;
    std::getline(file, sum);
    std::ostringstream rest;
    rest << file.rdbuf();
    std::string bytes = std::move(rest).str();
    if (bytes.empty() || checksum(bytes) != sum)
        return std::nullopt;
    return bytes;
}

void ObjectCache::store(const std::string &key, std::string_view bytes) {
    if (folder_.empty())
        return;
    std::lock_guard lock(mutex_);
    std::error_code error;
    fs::create_directories(folder_, error);
    // A name of its own for each writer; the rename makes the whole file appear at once.
    const fs::path temporary = folder_ / (key + "." + std::to_string(getpid()) + ".part");
    {
        std::ofstream file(temporary, std::ios::binary);
        file << checksum(bytes) << '\n' << bytes;
        file.close();
        if (!file) {
            fs::remove(temporary, error);
            return;
        }
    }
    fs::rename(temporary, fileOf(key), error);
    if (error)
        fs::remove(temporary, error);
    written_ += bytes.size();
    // Measuring a folder costs more than a store, so it is done now and then.
    if (!measured_ || written_ > limit_ / 16)
        evict();
}

void ObjectCache::evict() {
    struct Entry {
        fs::file_time_type written;
        fs::path path;
        std::uintmax_t size;
    };
    std::vector<Entry> entries;
    std::uintmax_t total = 0;
    std::error_code error;
    for (fs::directory_iterator it(folder_, error), end; !error && it != end; it.increment(error)) {
        if (it->path().extension() != extension)
            continue;
        std::error_code gone;
        Entry entry{it->last_write_time(gone), it->path(), it->file_size(gone)};
        if (gone)
            continue;
        total += entry.size;
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
        return a.written != b.written ? a.written < b.written : a.path < b.path;
    });
    for (const Entry &entry : entries) {
        if (total <= limit_)
            break;
        fs::remove(entry.path, error);
        total -= entry.size;
    }
    measured_ = true;
    written_ = 0;
}

} // namespace candela
