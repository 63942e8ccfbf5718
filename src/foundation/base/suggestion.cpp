// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/suggestion.h"

#include "foundation/base/letters.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace candela {

/// Number of letters to insert, delete, change or swap to make one word the other.
static std::size_t editDistance(const std::string &a, const std::string &b) {
    std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    std::iota(previous.begin(), previous.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            row[j] = std::min(
                {previous[j] + 1, row[j - 1] + 1, previous[j - 1] + (a[i - 1] != b[j - 1])});
            if (swapped)
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before = std::exchange(previous, row);
    }
    return previous[b.size()];
}

std::string suggestion(const std::string &word, const std::vector<std::string> &candidates) {
    if (word.size() > 64)
        return {};
    std::string best;
    std::size_t bestDistance =
        word.size() <= 3 ? 2 : 3; // One or two slips are likely, more are not.
    for (const std::string &candidate : candidates) {
        if (candidate == word || candidate.size() > 64)
            continue;
        bool sameLetters = inSmallLetters(word) == inSmallLetters(candidate);
        std::size_t distance = sameLetters ? 0 : editDistance(word, candidate);
        if (distance < bestDistance && distance < word.size()) {
            best = candidate;
            bestDistance = distance;
        }
    }
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

} // namespace candela
