// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/byte_output.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <unistd.h>
#include <utility>
#include <zlib.h>

namespace candela {

/// zlib writes both packed and plain files.
struct ByteOutput::File {
    gzFile handle;
    ~File() {
        if (handle)
            gzclose(handle);
    }
};

ByteOutput::ByteOutput() = default;
ByteOutput::~ByteOutput() {
    if (command_)
        pclose(command_);
}

std::unique_ptr<ByteOutput> ByteOutput::open(const std::string &path, Packing packing,
                                             std::string &why) {
    const char *mode = packing == Packing::Gzip ? "wb" : "wbT";
    errno = 0;
    gzFile handle = path == "-" ? gzdopen(dup(STDOUT_FILENO), mode) : gzopen(path.c_str(), mode);
    if (!handle) {
        why = errno ? std::strerror(errno) : "out of memory";
        return nullptr;
    }
    std::unique_ptr<ByteOutput> result(new ByteOutput);
    result->file_.reset(new File{handle});
    return result;
}

std::unique_ptr<ByteOutput> ByteOutput::toCommand(const std::string &command, std::string &why) {
    std::unique_ptr<ByteOutput> result(new ByteOutput);
    result->command_ = popen(command.c_str(), "we");
    if (!result->command_)
        why = std::strerror(errno);
    return result->command_ ? std::move(result) : nullptr;
}

std::unique_ptr<ByteOutput> ByteOutput::toMemory(std::string &text) {
    std::unique_ptr<ByteOutput> result(new ByteOutput);
    result->text_ = &text;
    return result;
}

std::unique_ptr<ByteOutput> ByteOutput::toHash(ContentHash &hash) {
    std::unique_ptr<ByteOutput> result(new ByteOutput);
    result->hash_ = &hash;
    return result;
}

static std::string reasonOf(int code, const char *message) {
    return code == Z_ERRNO ? std::strerror(errno) : message;
}

void ByteOutput::write(std::string_view bytes) {
    constexpr std::size_t most = 1 << 30; // gzwrite() counts in unsigned.
    if (text_)
        text_->append(bytes);
    if (hash_)
        hash_->add(bytes);
    if (command_ && !failed() &&
        std::fwrite(bytes.data(), 1, bytes.size(), command_) < bytes.size())
        failure_ = std::strerror(errno);
    for (; file_ && !failed() && !bytes.empty(); bytes.remove_prefix(std::min(most, bytes.size())))
        if (gzwrite(file_->handle, bytes.data(), unsigned(std::min(most, bytes.size()))) <= 0) {
            int code = Z_OK;
            const char *message = gzerror(file_->handle, &code);
            failure_ = reasonOf(code, message);
        }
}

std::string ByteOutput::close() {
    if (file_ && file_->handle) {
        const int code = gzclose(std::exchange(file_->handle, nullptr));
        if (code != Z_OK && !failed())
            failure_ = reasonOf(code, "the file could not be completed");
    }
    if (command_) {
        const int status = pclose(std::exchange(command_, nullptr));
        if (status != 0 && !failed())
            failure_ = "the command ended with status " + std::to_string(status);
    }
    return failure_;
}

} // namespace candela
