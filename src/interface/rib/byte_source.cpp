// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/byte_source.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <zlib.h>

namespace candela {

static constexpr std::size_t windowSize = 1 << 16;

ByteSource::ByteSource(Read read) : read_(std::move(read)) {
    if (read_)
        window_.resize(windowSize);
}

/// zlib reads plain files as they are and compressed ones decompressed: it looks for 1F 8B.
static std::size_t readPacked(gzFile file, char *to, std::size_t most, std::string &failure) {
    const int count = gzread(file, to, unsigned(most));
    int code = Z_OK;
    const char *message = gzerror(file, &code);
    if (code != Z_OK && code != Z_STREAM_END)
        failure = code == Z_ERRNO ? std::strerror(errno) : message;
    return count > 0 ? std::size_t(count) : 0;
}

std::unique_ptr<ByteSource> ByteSource::open(const std::string &path, std::string &why) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        why = "it is a folder";
        return nullptr;
    }
    errno = 0;
    gzFile handle = path == "-" ? gzdopen(dup(STDIN_FILENO), "rb") : gzopen(path.c_str(), "rb");
    if (!handle) {
        why = errno ? std::strerror(errno) : "out of memory";
        return nullptr;
    }
    gzbuffer(handle, windowSize);
    const std::shared_ptr<gzFile_s> file(handle, gzclose);
    return std::make_unique<ByteSource>([file](char *to, std::size_t most, std::string &failure) {
        return readPacked(file.get(), to, most, failure);
    });
}

std::unique_ptr<ByteSource> ByteSource::fromMemory(std::string bytes) {
    auto result = std::make_unique<ByteSource>(Read());
    result->window_ = std::move(bytes);
    result->end_ = result->window_.size();
    return result;
}

/// Reads on until the byte `ahead` is in the window; false at the end.
bool ByteSource::fill(std::size_t ahead) {
    if (!read_ || !failure_.empty())
        return false;
    std::copy(window_.begin() + std::ptrdiff_t(next_), window_.begin() + std::ptrdiff_t(end_),
              window_.begin());
    end_ -= next_;
    before_ += next_;
    next_ = 0;
    while (end_ <= ahead) {
        const std::size_t count = read_(window_.data() + end_, window_.size() - end_, failure_);
        if (count == 0)
            return false;
        end_ += count;
    }
    return true;
}

} // namespace candela
