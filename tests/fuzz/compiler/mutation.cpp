// SPDX-License-Identifier: Apache-2.0
#include "mutation.h"

#include "expressions.h"
#include "token_stream.h"
#include "vocabulary.h"

#include <algorithm>

namespace candela::fuzz {

namespace {

using Places = std::vector<std::size_t>;

template <typename Chosen> Places places(const Words &words, Chosen &&chosen) {
    Places found;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (chosen(words[i]))
            found.push_back(i);
    return found;
}

using Mutation = void (*)(Words &, const Corpus &, Chance &);

void changeNumbers(Words &words, const Corpus &, Chance &chance) {
    const Places numbers = places(words, isNumber);
    if (numbers.empty())
        return;
    constexpr std::size_t counts[] = {1, 1, 1, 2, 3, 9};
    const std::size_t first = chance.below(numbers.size());
    const std::size_t end = std::min(numbers.size(), first + chance.pick(counts));
    for (std::size_t k = first; k < end; ++k)
        words[numbers[k]].text = chance.pick(vocabulary().numbers);
}

void changeString(Words &words, const Corpus &, Chance &chance) {
    if (const Places strings = places(words, isString); !strings.empty())
        words[chance.pick(strings)].text = chance.pick(vocabulary().strings);
}

/// A word by another of a list that it stands in; false if it stands in none.
bool exchangeWithin(const std::vector<Vocabulary::Spellings> &lists, Word &word, Chance &chance) {
    for (const Vocabulary::Spellings &list : lists)
        if (std::ranges::find(list, word.text) != list.end()) {
            word.text = chance.pick(list);
            return true;
        }
    return false;
}

/// A type by a type, an operator by an operator, a name by another name of the text.
void exchangeWord(Words &words, const Corpus &, Chance &chance) {
    const auto &lists = chance.oneIn(5) ? vocabulary().related : vocabulary().alike;
    const Places names = places(words, isName);
    for (int tries = 0; tries < 20; ++tries) {
        Word &word = words[chance.below(words.size())];
        if (exchangeWithin(lists, word, chance))
            return;
        if (isName(word) && chance.oneIn(4)) {
            word.text = words[chance.pick(names)].text;
            return;
        }
    }
}

void dropWord(Words &words, const Corpus &, Chance &chance) {
    const std::size_t at = chance.below(words.size());
    replace(words, {at, at + 1}, {});
}
void doubleWord(Words &words, const Corpus &, Chance &chance) {
    const std::size_t at = chance.below(words.size());
    replace(words, {at, at}, {{words[at].space.empty() ? " " : words[at].space, words[at].text}});
}
void swapWords(Words &words, const Corpus &, Chance &chance) {
    std::swap(words[chance.below(words.size())].text, words[chance.below(words.size())].text);
}
void insertWords(Words &words, const Corpus &corpus, Chance &chance) {
    const std::size_t at = chance.below(words.size()), count = 1 + chance.below(20);
    replace(words, {at, at},
            chance.oneIn(2) ? randomWords(count, chance) : plausibleWords(count, corpus, chance));
}

/// Drops, doubles or moves a line.
void changeLine(Words &words, const Corpus &, Chance &chance) {
    const std::vector<Span> lines = linesOf(words);
    const Span line = chance.pick(lines);
    const Words copy = copyOf(words, line);
    const std::size_t to = chance.pick(lines).begin;
    const std::size_t kind = chance.below(3);
    if (kind == 0)
        replace(words, line, {});
    else if (kind == 1)
        replace(words, {line.end, line.end}, copy);
    else
        replace(words, {to, to}, copy);
}

Words anyPart(const Words &words, std::vector<Span> (*parts)(const Words &), Chance &chance) {
    const std::vector<Span> found = parts(words);
    return found.empty() ? Words{} : copyOf(words, chance.pick(found));
}

/// A part of a text in the place of another of the same form.
template <std::vector<Span> (*parts)(const Words &)>
void exchangePart(Words &words, const Corpus &corpus, Chance &chance) {
    const std::vector<Span> own = parts(words);
    if (own.empty())
        return;
    const Words piece = anyPart(chance.oneIn(2) ? words : chance.pick(corpus.texts), parts, chance);
    if (piece.size() < 400)
        replace(words, chance.pick(own), piece);
}

void repeatStatement(Words &words, const Corpus &, Chance &chance) {
    const std::vector<Span> statements = statementsOf(words);
    if (statements.empty())
        return;
    constexpr std::size_t counts[] = {1, 1, 1, 2, 9, 39};
    const Span statement = chance.pick(statements);
    const Words copy = copyOf(words, statement);
    const std::size_t count = copy.size() > 50 ? 1 : chance.pick(counts);
    for (std::size_t n = 0; n < count; ++n)
        replace(words, {statement.end, statement.end}, copy);
}

void moveStatement(Words &words, const Corpus &corpus, Chance &chance) {
    const Words piece =
        anyPart(chance.oneIn(2) ? words : chance.pick(corpus.texts), statementsOf, chance);
    const std::vector<Span> own = statementsOf(words);
    if (own.empty() || piece.size() >= 400)
        return;
    const std::size_t at = chance.pick(own).end;
    replace(words, {at, at}, piece);
}

void insertStatement(Words &words, const Corpus &, Chance &chance) {
    const std::vector<Span> statements = statementsOf(words);
    if (statements.empty())
        return;
    const std::size_t at = chance.pick(statements).end;
    replace(words, {at, at}, wordsOf("\n" + randomStatement(chance)));
}

void insertExpression(Words &words, const Corpus &, Chance &chance) {
    const Places numbers = places(words, isNumber);
    if (numbers.empty())
        return;
    const std::size_t at = chance.pick(numbers);
    const std::string text = randomExpression(sl::BaseType::Float, 3, chance);
    replace(words, {at, at + 1}, wordsOf(" (" + text + ")"));
}

struct Wrapping {
    const char *before, *after;
    std::size_t most = 5000; ///< Layers.
};

/// Layers around an argument or a statement: a few, or far too many. Few of loops: the marking of
/// live values goes through a loop's body twice, which doubles with each level.
void nest(Words &words, const Corpus &, Chance &chance) {
    static constexpr Wrapping expressions[] = {
        {"(", ")"},     {"-", ""},          {"!", ""},         {"sin(", ")"},
        {"float ", ""}, {"(1 ? ", " : 0)"}, {"max(0, ", ")"},  {"color(", ", 0, 0)"},
        {"(u + ", ")"}, {"vector (", ")"},  {"abs(v * ", ")"}, {"x[", "]"}};
    static constexpr Wrapping statements[] = {{"{", "}"},
                                              {"if (u < v) ", ""},
                                              {"if (u < 0.5) {", "} else { Ci = 0; }"},
                                              {"for (i = 0; i < 2; i += 1) ", "", 5},
                                              {"illuminance(P) {", "}"},
                                              {"while (0) ", "", 5}};
    const bool statement = chance.oneIn(2);
    const std::vector<Span> parts = statement ? statementsOf(words) : argumentsOf(words);
    if (parts.empty())
        return;
    constexpr std::size_t depths[] = {1, 1, 1, 1, 2, 2, 3, 3, 5, 30, 300, 5000};
    const Span span = chance.pick(parts);
    const Wrapping layer = statement ? chance.pick(statements) : chance.pick(expressions);
    const std::size_t depth = std::min(layer.most, chance.pick(depths));
    std::string before, after;
    for (std::size_t n = 0; n < depth; ++n) {
        before += layer.before;
        after += layer.after;
    }
    Words nested = wordsOf(before);
    const Words inner = copyOf(words, span), behind = wordsOf(after);
    nested.insert(nested.end(), inner.begin(), inner.end());
    nested.insert(nested.end(), behind.begin(), behind.end());
    replace(words, span, nested);
}

void insertDirective(Words &words, const Corpus &, Chance &chance) {
    const std::size_t at = chance.pick(linesOf(words)).begin;
    std::string line = chance.pick(vocabulary().directives);
    if (chance.oneIn(3)) // A macro of a word that the text uses.
        line = "#define " + chance.pick(words).text + " " + textOf(randomWords(3, chance));
    replace(words, {at, at}, {{"\n", line + "\n"}});
}

void cut(Words &words, const Corpus &, Chance &chance) {
    replace(words, {chance.below(words.size()), words.size()}, {});
}

void changeByte(Words &words, const Corpus &, Chance &chance) {
    std::string &text = words[chance.below(words.size())].text;
    if (!text.empty())
        text[chance.below(text.size())] = char(chance.below(256));
}

struct Way {
    Mutation mutate;
    int weight;
};
constexpr Way ways[] = {
    {changeNumbers, 14},
    {changeString, 4},
    {exchangeWord, 26},
    {dropWord, 2},
    {doubleWord, 1},
    {swapWords, 1},
    {insertWords, 2},
    {changeLine, 4},
    {exchangePart<groupsOf>, 3},
    {exchangePart<argumentsOf>, 9},
    {exchangePart<statementsOf>, 5},
    {repeatStatement, 6},
    {moveStatement, 5},
    {insertStatement, 14},
    {insertExpression, 6},
    {nest, 8},
    {insertDirective, 3},
    {cut, 1},
    {changeByte, 1},
};

} // namespace

void mutate(Words &words, const Corpus &corpus, Chance &chance) {
    if (words.empty())
        return;
    int total = 0;
    for (const Way &way : ways)
        total += way.weight;
    int at = int(chance.below(std::size_t(total)));
    for (const Way &way : ways)
        if ((at -= way.weight) < 0)
            return way.mutate(words, corpus, chance);
}

} // namespace candela::fuzz
