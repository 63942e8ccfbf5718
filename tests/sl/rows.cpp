// SPDX-License-Identifier: Apache-2.0
#include "sl/rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace candela::sl::test {

namespace {

std::string trimmed(const std::string &text) {
    const size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == text.npos ? "" : text.substr(first, last - first + 1);
}

std::vector<std::string> fieldsOf(const std::string &line) {
    constexpr std::string_view between = " | ";
    std::vector<std::string> fields;
    size_t begin = 0;
    for (size_t end; (end = line.find(between, begin)) != line.npos; begin = end + between.size())
        fields.push_back(trimmed(line.substr(begin, end - begin)));
    fields.push_back(trimmed(line.substr(begin)));
    return fields;
}

/// "1 2 3" or "1 2 3 ~1e-4"
bool readNumbers(const std::string &text, Row &row) {
    std::istringstream stream(text);
    for (std::string word; stream >> word;)
        (word[0] == '~' ? row.tolerance : row.expected.emplace_back()) =
            std::stof(word[0] == '~' ? word.substr(1) : word);
    return !row.expected.empty();
}

} // namespace

std::string Row::statements() const {
    return code.find("result") == code.npos ? "result = " + code + ";" : code;
}

std::vector<Row> readRows(const std::string &path) {
    std::vector<Row> rows;
    std::ifstream file(path);
    EXPECT_TRUE(file) << path;
    std::string line, before;
    const std::string name = std::filesystem::path(path).filename().string();
    for (int number = 1; std::getline(file, line); ++number) {
        if (trimmed(line).empty() || line[0] == '#')
            continue;
        if (line[0] == '+') { // A function for the next row.
            before += line.substr(1) + "\n";
            continue;
        }
        const std::vector<std::string> fields = fieldsOf(line);
        Row row;
        row.where = name + ":" + std::to_string(number);
        const bool isRow = fields.size() == 3 && readNumbers(fields[2], row);
        EXPECT_TRUE(isRow) << row.where << ": expected TYPE | CODE | NUMBERS";
        if (!isRow)
            continue;
        row.type = fields[0], row.code = fields[1], row.before = std::exchange(before, {});
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<std::string> rowFiles() {
    std::vector<std::string> files;
    for (const auto &entry : std::filesystem::directory_iterator(CANDELA_SOURCE_DIR "/tests/sl"))
        if (entry.path().extension() == ".rows")
            files.push_back(entry.path().string());
    std::ranges::sort(files);
    return files;
}

} // namespace candela::sl::test
