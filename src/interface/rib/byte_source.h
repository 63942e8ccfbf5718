// SPDX-License-Identifier: Apache-2.0
// Bytes as a stream with a window to look ahead in, from memory, from a file that may be compressed
// with gzip, or from elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace candela {

class ByteSource {
public:
    /// Nothing if the file cannot be opened; `why` then says so. "-" is the standard input.
    static std::unique_ptr<ByteSource> open(const std::string &path, std::string &why);
    static std::unique_ptr<ByteSource> fromMemory(std::string bytes);
    /// Puts up to so many bytes there and says how many; none at the end, or if there is a failure.
    using Read = std::function<std::size_t(char *to, std::size_t most, std::string &failure)>;
    explicit ByteSource(Read);

    /// The byte `ahead` of the next one, or -1 after the end. `ahead` is below 256.
    int peek(std::size_t ahead = 0) {
        return next_ + ahead < end_ || fill(ahead) ? (unsigned char)window_[next_ + ahead] : -1;
    }
    void skip(std::size_t count = 1) { next_ += count; }
    /// What is at hand of the bytes that come; peek() brings more once they have been skipped.
    std::string_view window() const { return {window_.data() + next_, end_ - next_}; }
    /// Bytes passed so far.
    std::uint64_t position() const { return before_ + next_; }
    /// What went wrong while reading, as a damaged compressed file; empty if nothing did.
    const std::string &failure() const { return failure_; }

private:
    bool fill(std::size_t ahead);

    Read read_; ///< None: the window is all there is.
    std::string window_;
    std::size_t next_ = 0, end_ = 0;
    std::uint64_t before_ = 0; ///< Bytes that have left the window.
    std::string failure_;
};

} // namespace candela
