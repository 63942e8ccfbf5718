// SPDX-License-Identifier: Apache-2.0
#include "corpus.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace candela::fuzz {

void Corpus::add(std::string_view text) {
    texts.push_back(wordsOf(text));
    const Words &words = texts.back();
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
        followers[words[i].text].push_back(words[i + 1].text);
}

Corpus readCorpus(const std::vector<std::string> &folders) {
    std::vector<std::filesystem::path> paths;
    for (const std::string &folder : folders)
        for (const auto &entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.path().extension() == ".sl")
                paths.push_back(entry.path());
    std::ranges::sort(paths);
    Corpus corpus;
    for (const auto &path : paths) {
        std::ifstream file(path, std::ios::binary);
        corpus.add(std::string(std::istreambuf_iterator<char>(file), {}));
    }
    return corpus;
}

} // namespace candela::fuzz
