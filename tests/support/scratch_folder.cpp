// SPDX-License-Identifier: Apache-2.0
#include "tests/support/scratch_folder.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace candela::test {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
    path_ = (fs::temp_directory_path() / "candela-test-XXXXXX").string();
    if (!mkdtemp(path_.data())) {
        std::perror("cannot make a folder for the test");
        std::abort();
    }
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string ScratchFolder::write(const std::string &name, const std::string &content) const {
    std::string file = path(name);
    fs::create_directories(fs::path(file).parent_path());
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

std::string ScratchFolder::read(const std::string &name) const { return contentOf(path(name)); }

bool ScratchFolder::has(const std::string &name) const { return fs::exists(path(name)); }

std::string contentOf(const std::string &path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
}

} // namespace candela::test
