// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/preprocessor.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "language/syntax/condition.h"
#include "language/syntax/lexer.h"
#include "language/syntax/macro.h"

namespace candela::sl {
namespace {

constexpr int includeDepthLimit = 64;
constexpr int includeCountLimit = 1000; // Two files that include each other twice make 2^64.
constexpr uintmax_t fileSizeLimit = 16 << 20;

std::optional<std::string> readFile(const std::filesystem::path &path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error) ||
        std::filesystem::file_size(path, error) > fileSizeLimit || error)
        return std::nullopt;
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

class Preprocessor {
public:
    Preprocessor(SourceSet &sources, const PreprocessorOptions &options, Reporter &reporter)
        : sources_(sources), options_(options), reporter_(reporter), macros_(reporter) {}

    PreprocessedFile run() {
        definePredefined();
        processFile(*sources_.front(), 0);
        return std::move(result_);
    }

private:
    struct Branch {
        Place where;
        bool active;      ///< Its lines count.
        bool taken;       ///< This or an earlier branch of it was active.
        bool outerActive; ///< The #if itself stands in active lines.
        bool sawElse = false;
    };

    void definePredefined() {
        int version =
            CANDELA_VERSION_MAJOR * 10000 + CANDELA_VERSION_MINOR * 100 + CANDELA_VERSION_PATCH;
        auto dotted = std::to_string(CANDELA_VERSION_MAJOR) + "." +
                      std::to_string(CANDELA_VERSION_MINOR) + "." +
                      std::to_string(CANDELA_VERSION_PATCH);
        predefine("CANDELA", std::to_string(version));
        predefine("CANDELA_VERSION", '"' + dotted + '"');
        for (const auto &[name, value] : options_.defines)
            predefine(name, value);
    }

    void predefine(const std::string &name, const std::string &value) {
        auto file = std::make_unique<SourceFile>("definition of " + name, value);
        std::vector<Token> tokens = tokenize(*file, reporter_);
        tokens.pop_back(); // End
        sources_.push_back(std::move(file));
        macros_.define(name, {false, {}, withoutFlaws(std::move(tokens))});
    }

    void processFile(SourceFile &file, int depth) {
        TokenStream stream(tokenize(file, reporter_));
        size_t outerBranches = branches_.size();
        while (stream.peek().kind != TokenKind::End && !reporter_.hopeless()) {
            Token token = stream.take();
            if (token.is("#") && token.startsLine && !token.hidden)
                directive(restOfLine(stream), token, depth, outerBranches);
            else if (active() && !macros_.expand(token, stream))
                emit(std::move(token));
        }
        for (; branches_.size() > outerBranches; branches_.pop_back())
            reporter_.error(branches_.back().where,
                            "conditional is not closed; expected #endif before the end of file");
        if (depth == 0)
            result_.tokens.push_back(stream.peek());
    }

    void emit(Token token) {
        reportFlaw(token);
        if (token.kind != TokenKind::Stray)
            result_.tokens.push_back(std::move(token));
    }

    void reportFlaw(const Token &token) {
        if (token.flaw)
            reporter_.error(token.flaw->where, token.flaw->message);
    }

    /// Tokens that count from here on: their flaws are told, stray bytes dropped.
    std::vector<Token> withoutFlaws(std::vector<Token> tokens) {
        for (const Token &token : tokens)
            reportFlaw(token);
        std::erase_if(tokens, [](const Token &token) { return token.kind == TokenKind::Stray; });
        return tokens;
    }

    bool active() const { return branches_.empty() || branches_.back().active; }

    std::vector<Token> restOfLine(TokenStream &stream) {
        std::vector<Token> line;
        while (stream.peek().kind != TokenKind::End && !stream.peek().startsLine)
            line.push_back(stream.take());
        return line;
    }

    void directive(std::vector<Token> line, const Token &hash, int depth, size_t outerBranches) {
        if (line.empty())
            return;
        Token name = line.front();
        line.erase(line.begin());
        if (conditional(name, line, outerBranches) || !active())
            return;
        if (name.is("define"))
            define(line, name);
        else if (name.is("undef"))
            undefine(line, name);
        else if (name.is("include"))
            include(line, name, depth);
        else if (name.is("error"))
            reporter_.error(name.where, "#error: " + textOf(line));
        else if (name.is("warning"))
            reporter_.warning(name.where, "#warning: " + textOf(line));
        else if (!name.is("pragma") && !name.is("line") && !name.is("ident") &&
                 name.kind != TokenKind::Number)
            reporter_.error(hash.where, "unknown directive #" + name.spelling);
    }

    static std::string textOf(const std::vector<Token> &tokens) {
        std::string result;
        for (const Token &token : tokens)
            result += (result.empty() || !token.spaceBefore ? "" : " ") +
                      (token.kind == TokenKind::Text ? token.text : token.spelling);
        return result;
    }

    bool conditional(const Token &name, const std::vector<Token> &line, size_t outerBranches) {
        if (name.is("if") || name.is("ifdef") || name.is("ifndef")) {
            bool value = active() && opens(name, line);
            branches_.push_back({name.where, value, value, active()});
            return true;
        }
        if (!name.is("elif") && !name.is("else") && !name.is("endif"))
            return false;
        if (branches_.size() <= outerBranches) {
            reporter_.error(name.where, "#" + name.spelling + " without an #if before it");
            return true;
        }
        if (name.is("endif")) {
            branches_.pop_back();
            return true;
        }
        Branch &branch = branches_.back();
        if (branch.sawElse)
            reporter_.error(name.where, "#" + name.spelling + " after #else");
        branch.sawElse = name.is("else");
        bool candidate = branch.outerActive && !branch.taken;
        branch.active = candidate && (name.is("else") || condition(line, name));
        branch.taken |= branch.active;
        return true;
    }

    bool opens(const Token &name, const std::vector<Token> &line) {
        if (name.is("if"))
            return condition(line, name);
        if (line.empty() || !line[0].isIdentifier()) {
            reporter_.error(name.where, "expected a macro's name after #" + name.spelling);
            return false;
        }
        return macros_.isDefined(line[0].spelling) == name.is("ifdef");
    }

    bool condition(const std::vector<Token> &written, const Token &directive) {
        const std::vector<Token> line = withoutFlaws(written);
        std::vector<Token> answered;
        for (size_t i = 0; i < line.size(); ++i) {
            if (!line[i].is("defined")) {
                answered.push_back(line[i]);
                continue;
            }
            bool brackets = i + 3 < line.size() && line[i + 1].is("(") && line[i + 3].is(")");
            size_t word = i + (brackets ? 2 : 1);
            if (word >= line.size() || !line[word].isIdentifier()) {
                reporter_.error(line[i].where, "expected a macro's name after 'defined'");
                return false;
            }
            Token answer = line[i];
            answer.kind = TokenKind::Number;
            answer.number = macros_.isDefined(line[word].spelling);
            answer.spelling = answer.number ? "1" : "0";
            answered.push_back(answer);
            i = word + (brackets ? 1 : 0);
        }
        auto value = evaluateCondition(macros_.expandAll(answered), directive.where, reporter_);
        return value && *value != 0;
    }

    void define(const std::vector<Token> &line, const Token &directive) {
        if (line.empty() || !line[0].isIdentifier()) {
            reporter_.error(directive.where, "expected a name after #define");
            return;
        }
        Macro macro;
        size_t at = 1;
        if (line.size() > 1 && line[1].is("(") && !line[1].spaceBefore) {
            macro.takesArguments = true;
            if (!parameters(line, at, macro))
                return;
        }
        macro.body = withoutFlaws({line.begin() + long(at), line.end()});
        macros_.define(line[0].spelling, std::move(macro));
    }

    // At the '(' of a definition; leaves `at` behind the ')'.
    bool parameters(const std::vector<Token> &line, size_t &at, Macro &macro) {
        for (++at; at < line.size() && !line[at].is(")"); ++at) {
            if (line[at].is(",") && !macro.parameters.empty())
                ++at;
            if (at >= line.size() || !line[at].isIdentifier())
                break;
            macro.parameters.push_back(line[at].spelling);
        }
        if (at < line.size() && line[at].is(")")) {
            ++at;
            return true;
        }
        reporter_.error(line[std::min(at, line.size() - 1)].where,
                        "expected names and ')' in the parameter list of macro " +
                            line[0].spelling);
        return false;
    }

    void undefine(const std::vector<Token> &line, const Token &directive) {
        if (line.empty() || !line[0].isIdentifier())
            reporter_.error(directive.where, "expected a macro's name after #undef");
        else
            macros_.undefine(line[0].spelling);
    }

    void include(std::vector<Token> line, const Token &directive, int depth) {
        line = withoutFlaws(std::move(line));
        if (!line.empty() && line[0].isIdentifier())
            line = macros_.expandAll(line);
        std::string name;
        bool angled = !line.empty() && line[0].is("<");
        if (!line.empty() && line[0].kind == TokenKind::Text)
            name = line[0].text;
        for (size_t i = 1; angled && i < line.size() && !line[i].is(">"); ++i)
            name += line[i].spelling;
        if (name.empty()) {
            reporter_.error(directive.where, "expected \"file\" or <file> after #include");
            return;
        }
        if (depth + 1 >= includeDepthLimit || ++includeCount_ > includeCountLimit) {
            reporter_.error(line[0].where, "#include is nested too deeply at \"" + name +
                                               "\"; does the file include itself?");
            return;
        }
        open(name, angled, line[0].where, depth);
    }

    void open(const std::string &name, bool angled, const Place &where, int depth) {
        std::vector<std::filesystem::path> folders(options_.includeDirectories.begin(),
                                                   options_.includeDirectories.end());
        auto own = std::filesystem::path(where.file->name()).parent_path();
        folders.insert(angled ? folders.end() : folders.begin(), own);
        for (const auto &folder : folders) {
            auto path = folder / name;
            std::optional<std::string> text = readFile(path);
            if (!text)
                continue;
            auto &known = result_.includedFiles;
            if (std::ranges::find(known, path.string()) == known.end())
                known.push_back(path.string());
            sources_.push_back(std::make_unique<SourceFile>(path.string(), *text));
            processFile(*sources_.back(), depth + 1);
            return;
        }
        std::string searched;
        for (const auto &folder : folders)
            searched += (searched.empty() ? "" : ", ") + (folder.empty() ? "." : folder.string());
        reporter_.error(where, "cannot read \"" + name + "\"; searched: " + searched);
    }

    SourceSet &sources_;
    const PreprocessorOptions &options_;
    Reporter &reporter_;
    MacroTable macros_;
    std::vector<Branch> branches_;
    PreprocessedFile result_;
    int includeCount_ = 0;
};

} // namespace

PreprocessedFile preprocess(SourceSet &sources, const PreprocessorOptions &options,
                            Reporter &reporter) {
    return Preprocessor(sources, options, reporter).run();
}

} // namespace candela::sl
