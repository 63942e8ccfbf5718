// SPDX-License-Identifier: Apache-2.0
// Where written RIB goes.
#pragma once

#include "foundation/base/hash.h"

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

namespace candela {

class ByteOutput {
public:
    enum class Packing { Plain, Gzip };

    /// A file, or the standard output ("-"). Nothing if it cannot be opened; `why` then says so.
    static std::unique_ptr<ByteOutput> open(const std::string &path, Packing, std::string &why);
    /// The standard input of a command, given to the shell.
    static std::unique_ptr<ByteOutput> toCommand(const std::string &command, std::string &why);
    /// Ends up in `text`, which must outlive it.
    static std::unique_ptr<ByteOutput> toMemory(std::string &text);
    /// Is kept nowhere but added to `hash`, which must outlive it.
    static std::unique_ptr<ByteOutput> toHash(ContentHash &hash);
    ~ByteOutput();

    /// Nothing is written any more once it has failed.
    void write(std::string_view);
    bool failed() const { return !failure_.empty(); }
    /// After the last byte: what went wrong, now or earlier; empty if nothing did.
    std::string close();

private:
    struct File;
    ByteOutput();

    std::unique_ptr<File> file_;
    std::FILE *command_ = nullptr;
    std::string *text_ = nullptr;
    ContentHash *hash_ = nullptr;
    std::string failure_;
};

} // namespace candela
