// SPDX-License-Identifier: Apache-2.0
#include "tests/solved/ply.h"

#include <cstring>
#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace candela::test {

Ply readPly(const std::string &bytes) {
    Ply ply;
    const std::string end = "end_header\n";
    const std::size_t header = bytes.find(end);
    std::istringstream lines(bytes.substr(0, header));
    std::map<std::string, std::size_t> counts;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("element ")) {
            const std::size_t blank = line.find(' ', 8);
            counts[line.substr(8, blank - 8)] = std::stoul(line.substr(blank + 1));
        }
    const char *at = bytes.data() + header + end.size();
    ply.vertices.resize(counts["vertex"]);
    std::memcpy(ply.vertices.data(), at, ply.vertices.size() * sizeof ply.vertices[0]);
    at += ply.vertices.size() * sizeof ply.vertices[0];
    for (std::size_t f = 0; f < counts["face"]; ++f) {
        std::vector<int> &face = ply.faces.emplace_back(std::size_t(*at++));
        std::memcpy(face.data(), at, face.size() * sizeof(int));
        at += face.size() * sizeof(int);
    }
    EXPECT_EQ(at, bytes.data() + bytes.size());
    return ply;
}

} // namespace candela::test
