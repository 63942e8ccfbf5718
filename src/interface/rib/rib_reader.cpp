// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/rib_reader.h"

#include "interface/rib/request_reader.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace candela {

static constexpr int maximumArchiveDepth = 64;
/// Archives that read archives twice each grow fast.
static constexpr int maximumNestedReadings = 100000;

/// The same text for all names of a file.
static std::string identityOf(const std::string &path) {
    std::error_code error;
    auto canonical = std::filesystem::weakly_canonical(path, error);
    return error ? path : canonical.string();
}

void RibReader::read(Lexer lexer) {
    auto archives = [this](const auto &where, const auto &name) { readArchive(where, name); };
    RequestReader(std::move(lexer), sink_, diagnostics_, archives).run();
}

bool RibReader::readFile(const std::string &path) {
    std::string why;
    std::unique_ptr<ByteSource> source = ByteSource::open(path, why);
    if (!source) {
        diagnostics_.error({std::make_shared<const std::string>(path)},
                           "the file cannot be opened: " + why);
        return false;
    }
    open_.push_back(identityOf(path));
    read(Lexer(std::move(source), path, diagnostics_));
    open_.pop_back();
    return true;
}

void RibReader::readText(std::string text, const std::string &name) {
    read(Lexer(ByteSource::fromMemory(std::move(text)), name, diagnostics_));
}

void RibReader::readArchive(const SourceLocation &where, const std::string &name) {
    auto path = sink_.findArchive(name, where);
    if (!path) {
        diagnostics_.error(where, "ReadArchive: there is no archive '" + name +
                                      "' (a regular file) in the search path \"archive\", beside "
                                      "this file or in the current folder");
        return;
    }
    if (std::ranges::find(open_, identityOf(*path)) != open_.end())
        diagnostics_.error(where, "ReadArchive: '" + name + "' would read itself without end");
    else if (int(open_.size()) > maximumArchiveDepth)
        diagnostics_.error(where, "ReadArchive: archives are nested more than " +
                                      std::to_string(maximumArchiveDepth) + " deep");
    else if (open_.size() > 1 && ++nestedReadings_ > maximumNestedReadings)
        diagnostics_.error(where, "ReadArchive: '" + name + "' is left out: archives read " +
                                      std::to_string(maximumNestedReadings) + " others already");
    else
        readFile(*path);
}

} // namespace candela
