// SPDX-License-Identifier: Apache-2.0
// A folder for the files of one test, gone with it.
#pragma once

#include <string>

namespace candela::test {

class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder &) = delete;
    ScratchFolder &operator=(const ScratchFolder &) = delete;

    const std::string &path() const { return path_; }
    std::string path(const std::string &name) const { return path_ + "/" + name; }
    /// Writes a file (its folders too) and returns its path.
    std::string write(const std::string &name, const std::string &content) const;
    /// The content of a file; empty if there is none.
    std::string read(const std::string &name) const;
    bool has(const std::string &name) const;

private:
    std::string path_;
};

/// The content of any file; empty if it cannot be read.
std::string contentOf(const std::string &path);

} // namespace candela::test
