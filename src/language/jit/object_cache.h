// SPDX-License-Identifier: Apache-2.0
// Compiled objects on disk. A cache that can't be read or written is done without: everything in it
// can be made again. Objects are code that will run, so the folder and its files must be the user's
// own and nobody else's to write; what is not so is not used.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// Thread-safe.
class ObjectCache {
public:
    static constexpr std::uintmax_t defaultLimit = 256u << 20;

    /// No folder (an empty path) = no cache; one that isn't there is made when something is stored.
    /// Files beyond `limit` bytes in all are removed, those written first going first.
    explicit ObjectCache(std::filesystem::path folder, std::uintmax_t limit = defaultLimit);
    ~ObjectCache();
    ObjectCache(const ObjectCache &) = delete;
    ObjectCache &operator=(const ObjectCache &) = delete;

    /// The folder to use where none is given: $CANDELA_CACHE, else $XDG_CACHE_HOME/candela, else
    /// ~/.cache/candela; empty if none of these is set.
    static std::filesystem::path defaultFolder();

    /// The bytes stored under the key, if they are there, whole and to be trusted.
    std::optional<std::string> load(const std::string &key);
    /// Stores under the key; other processes see all or nothing of it.
    void store(const std::string &key, std::string_view bytes);
    void remove(const std::string &key);

    /// What is there and not used, and why; for the user, once. Empty if there is nothing.
    std::string takeObjection();

private:
    bool open();
    bool isOurs(int file, const std::filesystem::path &);
    void evict();

    std::filesystem::path folder_;
    std::uintmax_t limit_;
    std::mutex mutex_;
    int directory_ = -1; ///< Open while the folder is in use.
    std::string objection_;
    std::uintmax_t written_ = 0; ///< Since the folder was last measured.
    bool measured_ = false;
};

} // namespace candela
