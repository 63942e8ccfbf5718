// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/preprocessor.h"

#include <algorithm>

#include "language/syntax/conditionals.h"
#include "language/syntax/flaws.h"
#include "language/syntax/include.h"
#include "language/syntax/lexer.h"
#include "language/syntax/macro.h"
#include "language/syntax/macro_definition.h"
#include "language/syntax/version.h"

namespace candela::sl {
namespace {

constexpr int includeDepthLimit = 64;
constexpr int includeCountLimit = 1000; // Two files that include each other twice make 2^64.

std::vector<Token> restOfLine(TokenStream &stream) {
    std::vector<Token> line;
    while (stream.peek().kind != TokenKind::End && !stream.peek().startsLine)
        line.push_back(stream.take());
    return line;
}

std::string textOf(const std::vector<Token> &tokens) {
    std::string result;
    for (const Token &token : tokens)
        result += (result.empty() || !token.spaceBefore ? "" : " ") +
                  (token.kind == TokenKind::Text ? token.text : token.spelling);
    return result;
}

class Preprocessor {
public:
    Preprocessor(SourceSet &sources, const PreprocessorOptions &options, Reporter &reporter)
        : sources_(sources), options_(options), reporter_(reporter), macros_(reporter) {}

    PreprocessedFile run() {
        definePredefined();
        Token end = processFile(*sources_.front());
        result_.tokens.push_back(std::move(end));
        return std::move(result_);
    }

private:
    void definePredefined() {
        const auto [major, minor, patch] = version();
        predefine("CANDELA", std::to_string(major * 10000 + minor * 100 + patch));
        predefine("CANDELA_VERSION", '"' + versionText() + '"');
        for (const auto &[name, value] : options_.defines)
            predefine(name, value);
    }

    void predefine(const std::string &name, const std::string &value) {
        auto file = std::make_unique<SourceFile>("definition of " + name, value);
        std::vector<Token> tokens = tokenize(*file, reporter_);
        tokens.pop_back(); // End
        sources_.push_back(std::move(file));
        macros_.define(name, {false, {}, withoutFlaws(std::move(tokens), reporter_)});
    }

    /// Returns the token at which reading has stopped.
    Token processFile(SourceFile &file) {
        TokenStream stream(tokenize(file, reporter_));
        Conditionals conditionals(macros_, reporter_);
        while (stream.peek().kind != TokenKind::End && !reporter_.hopeless()) {
            Token token = stream.take();
            if (token.is("#") && token.startsLine && !token.hidden)
                directive(restOfLine(stream), token, conditionals);
            else if (conditionals.active() && !macros_.expand(token, stream))
                emit(std::move(token));
        }
        conditionals.end();
        return stream.peek();
    }

    void emit(Token token) {
        reportFlaw(token, reporter_);
        if (token.kind != TokenKind::Stray)
            result_.tokens.push_back(std::move(token));
    }

    void directive(std::vector<Token> line, const Token &hash, Conditionals &conditionals) {
        if (line.empty())
            return;
        Token name = line.front();
        line.erase(line.begin());
        if (conditionals.obey(name, line) || !conditionals.active())
            return;
        if (name.is("define"))
            define(line, name);
        else if (name.is("undef"))
            undefine(line, name);
        else if (name.is("include"))
            include(std::move(line), name);
        else if (name.is("error"))
            reporter_.error(name.where, "#error: " + textOf(line));
        else if (name.is("warning"))
            reporter_.warning(name.where, "#warning: " + textOf(line));
        else if (!name.is("pragma") && !name.is("line") && !name.is("ident") &&
                 name.kind != TokenKind::Number)
            reporter_.warning(hash.where, "unknown directive #" + name.spelling + " is ignored");
    }

    void define(const std::vector<Token> &line, const Token &directive) {
        auto definition = readDefinition(line, directive, reporter_);
        if (definition && mayChange(definition->name, line[0].where))
            macros_.define(definition->name, std::move(definition->macro));
    }

    void undefine(const std::vector<Token> &line, const Token &directive) {
        if (line.empty() || !line[0].isIdentifier())
            reporter_.error(directive.where, "expected a macro's name after #undef");
        else if (mayChange(line[0].spelling, line[0].where))
            macros_.undefine(line[0].spelling);
    }

    bool mayChange(const std::string &name, const Place &where) {
        if (!MacroTable::isOfPlace(name))
            return true;
        reporter_.error(where, name + " tells where it stands: it can be neither defined nor "
                                      "undefined");
        return false;
    }

    void include(std::vector<Token> line, const Token &directive) {
        line = withoutFlaws(std::move(line), reporter_);
        if (!line.empty() && line[0].isIdentifier())
            line = macros_.expandAll(line);
        IncludeName named = includeName(line);
        if (named.name.empty()) {
            reporter_.error(directive.where, "expected \"file\" or <file> after #include");
            return;
        }
        const Place &where = line[0].where;
        if (includeDepth_ + 1 >= includeDepthLimit || ++includeCount_ > includeCountLimit) {
            reporter_.error(where, "#include is nested too deeply at \"" + named.name +
                                       "\"; does the file include itself?");
            return;
        }
        if (auto file = readInclude(named, where, options_.includeDirectories, reporter_))
            enter(std::move(file));
    }

    void enter(std::unique_ptr<SourceFile> file) {
        auto &known = result_.includedFiles;
        if (std::ranges::find(known, file->name()) == known.end())
            known.push_back(file->name());
        SourceFile &entered = *sources_.emplace_back(std::move(file));
        ++includeDepth_;
        processFile(entered);
        --includeDepth_;
    }

    SourceSet &sources_;
    const PreprocessorOptions &options_;
    Reporter &reporter_;
    MacroTable macros_;
    PreprocessedFile result_;
    int includeDepth_ = 0; ///< 0 in the main file.
    int includeCount_ = 0;
};

} // namespace

PreprocessedFile preprocess(SourceSet &sources, const PreprocessorOptions &options,
                            Reporter &reporter) {
    return Preprocessor(sources, options, reporter).run();
}

} // namespace candela::sl
