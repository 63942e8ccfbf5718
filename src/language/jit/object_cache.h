// SPDX-License-Identifier: Apache-2.0
// Compiled objects on disk. A cache that can't be read or written is done without, silently:
// everything in it can be made again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace candela {

class ObjectCache {
public:
    static constexpr std::uintmax_t defaultLimit = 256u << 20;

    /// No folder (an empty path) = no cache. Files beyond `limit` bytes in all are removed, those
    /// written first going first.
    explicit ObjectCache(std::filesystem::path folder, std::uintmax_t limit = defaultLimit);

    /// The folder to use where none is given: $CANDELA_CACHE, else $XDG_CACHE_HOME/candela, else
    /// ~/.cache/candela; empty if none of these is set.
    static std::filesystem::path defaultFolder();

    /// The bytes stored under the key, if they are there and whole.
    std::optional<std::string> load(const std::string &key) const;
    /// Stores under the key; other processes see all or nothing of it.
    void store(const std::string &key, std::string_view bytes);

private:
    std::filesystem::path fileOf(const std::string &key) const;
    void evict();

    std::filesystem::path folder_;
    std::uintmax_t limit_;
    std::mutex mutex_;
    std::uintmax_t written_ = 0; ///< Since the folder was last measured.
    bool measured_ = false;
};

} // namespace candela
