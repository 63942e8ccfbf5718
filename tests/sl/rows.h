// SPDX-License-Identifier: Apache-2.0
// Rows of tests/sl/*.rows: a piece of a shader and the numbers that it has to give (README.md).
#pragma once

#include <string>
#include <vector>

namespace candela::sl::test {

struct Row {
    std::string where;  ///< "maths.rows:12"
    std::string type;   ///< Of `result`: "float", "color"...
    std::string code;   ///< An expression, or statements that set `result`.
    std::string before; ///< Functions that stand before the shader.
    std::vector<float> expected;
    float tolerance = 2e-6f; ///< Relative above 1, absolute below.

    /// The code as statements.
    std::string statements() const;
};

/// The rows of a file, in their order. What is no row is a failure of the test that reads it.
std::vector<Row> readRows(const std::string &path);
/// All files of tests/sl that hold rows.
std::vector<std::string> rowFiles();

} // namespace candela::sl::test
