// SPDX-License-Identifier: Apache-2.0
#include "token_stream.h"

#include "vocabulary.h"

namespace candela::fuzz {

namespace {

struct Class {
    Vocabulary::Spellings Vocabulary::*words;
    int weight;
};
constexpr Class classes[] = {
    {&Vocabulary::types, 8},      {&Vocabulary::kinds, 2},      {&Vocabulary::storage, 2},
    {&Vocabulary::statements, 5}, {&Vocabulary::functions, 14}, {&Vocabulary::variables, 14},
    {&Vocabulary::operators, 16}, {&Vocabulary::brackets, 26},  {&Vocabulary::numbers, 8},
    {&Vocabulary::strings, 3},    {&Vocabulary::strays, 1},
};
constexpr int totalWeight = [] {
    int sum = 0;
    for (const Class &each : classes)
        sum += each.weight;
    return sum;
}();

constexpr const char *names[] = {"x", "y", "foo", "X", "J", "S", "E", "a"};

std::size_t streamLength(Chance &chance) {
    constexpr std::size_t longest[] = {10, 60, 60, 300, 300, 2000};
    return 1 + chance.below(chance.pick(longest));
}

} // namespace

Word randomWord(Chance &chance) {
    if (chance.oneIn(40))
        return {"\n", chance.pick(vocabulary().directives) + "\n"};
    const std::string space = chance.oneIn(12) ? "\n" : chance.oneIn(20) ? "" : " ";
    if (chance.oneIn(10))
        return {space, chance.pick(names)};
    int at = int(chance.below(totalWeight));
    for (const Class &each : classes)
        if ((at -= each.weight) < 0)
            return {space, chance.pick(vocabulary().*each.words)};
    return {};
}

Words randomWords(std::size_t count, Chance &chance) {
    Words words;
    while (words.size() < count)
        words.push_back(randomWord(chance));
    return words;
}

Words plausibleWords(std::size_t count, const Corpus &corpus, Chance &chance) {
    Words words{randomWord(chance)};
    while (words.size() < count) {
        const auto known = corpus.followers.find(words.back().text);
        if (known == corpus.followers.end() || chance.oneIn(25))
            words.push_back(randomWord(chance));
        else
            words.push_back({" ", chance.pick(known->second)});
    }
    return words;
}

std::string randomStream(const Corpus &corpus, Chance &chance) {
    const std::size_t count = streamLength(chance);
    const std::string words = textOf(chance.oneIn(3) ? randomWords(count, chance)
                                                     : plausibleWords(count, corpus, chance));
    switch (chance.below(6)) {
    case 0: return "light l() {" + words + "}\n";
    case 1: return "surface s(" + words + ") { Ci = Cs; }\n";
    case 2: return "float f(float x) {" + words + "}\nsurface s() { Ci = f(u); }\n";
    case 3: return words;
    default: return "surface s() {" + words + "}\n";
    }
}

} // namespace candela::fuzz
