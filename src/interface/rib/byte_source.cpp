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

/// zlib reads plain files as they are and compressed ones decompressed: it looks for 1F 8B.
struct ByteSource::File {
    gzFile handle;
    ~File() { gzclose(handle); }
};

ByteSource::ByteSource() = default;
ByteSource::~ByteSource() = default;

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
    gzbuffer(handle, 1 << 16);
    std::unique_ptr<ByteSource> result(new ByteSource);
    result->file_.reset(new File{handle});
    result->window_.resize(1 << 16);
    return result;
}

std::unique_ptr<ByteSource> ByteSource::fromMemory(std::string bytes) {
    std::unique_ptr<ByteSource> result(new ByteSource);
    result->window_ = std::move(bytes);
    result->end_ = result->window_.size();
    return result;
}

/// Reads on until the byte `ahead` is in the window; false at the end.
bool ByteSource::fill(std::size_t ahead) {
    if (!file_ || !failure_.empty())
        return false;
    std::copy(window_.begin() + next_, window_.begin() + end_, window_.begin());
    end_ -= next_;
    before_ += next_;
    next_ = 0;
    while (end_ <= ahead) {
        int count = gzread(file_->handle, window_.data() + end_, unsigned(window_.size() - end_));
        int code = Z_OK;
        const char *message = gzerror(file_->handle, &code);
        if (code != Z_OK && code != Z_STREAM_END)
            failure_ = code == Z_ERRNO ? std::strerror(errno) : message;
        if (count <= 0)
            return false;
        end_ += std::size_t(count);
    }
    return true;
}

} // namespace candela
