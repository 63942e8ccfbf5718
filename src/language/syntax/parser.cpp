// SPDX-License-Identifier: Apache-2.0
// Shaders, and the file as a whole.
#include "language/syntax/parser.h"

#include <algorithm>

#include "language/syntax/declaration_parser.h"
#include "language/syntax/expression_parser.h"
#include "language/syntax/lookahead.h"
#include "language/syntax/rsl2.h"
#include "language/syntax/statement_parser.h"
#include "language/syntax/token_cursor.h"

namespace candela::sl {
namespace {

std::string commentBefore(const Place &where) {
    if (where.file)
        for (const Comment &comment : where.file->comments)
            if (comment.lastLine < where.line && comment.lastLine >= where.line - 2)
                return comment.text;
    return {};
}

/// Gives each variable of a list that begins in that line the comment on its own line, or else the
/// one above it.
void attachComments(std::vector<ast::Variable> &list, int firstLine) {
    auto onLine = [&](int line) {
        return std::ranges::any_of(list, [&](auto &v) { return v.where.line == line; });
    };
    for (ast::Variable &variable : list) {
        const SourceFile *file = variable.where.file;
        for (const Comment &comment : file->comments) {
            bool same = comment.firstLine == variable.where.line;
            bool above = comment.lastLine == variable.where.line - 1 &&
                         comment.firstLine >= firstLine && !onLine(comment.firstLine);
            if (same || (above && variable.doc.empty()))
                variable.doc = comment.text;
        }
    }
}

class FileParser {
public:
    FileParser(const std::vector<Token> &tokens, Reporter &reporter) : tokens_(tokens, reporter) {}

    ast::File file();

private:
    ast::Item item();
    ast::Shader shader();
    void skipPrototype();
    void recover();

    TokenCursor tokens_;
    Lookahead ahead_{tokens_};
    ExpressionParser expressions_{tokens_, ahead_};
    DeclarationParser declarations_{tokens_, ahead_, expressions_};
    StatementParser statements_{tokens_, ahead_, expressions_, declarations_};
};

ast::File FileParser::file() {
    ast::File result;
    while (!tokens_.atEnd() && !tokens_.reporter().hopeless()) {
        if (tokens_.accept(";"))
            continue;
        if (ahead_.startsPrototype()) {
            skipPrototype();
            continue;
        }
        try {
            result.items.push_back(item());
        } catch (Panic) {
            recover();
        }
    }
    return result;
}

/// All functions of a file know each other anyway.
void FileParser::skipPrototype() {
    while (!tokens_.accept(";"))
        tokens_.take();
}

ast::Item FileParser::item() {
    if (ahead_.startsShader())
        return shader();
    if (ahead_.startsFunction())
        return statements_.function();
    if (const std::string construct = rsl2Construct(tokens_); !construct.empty())
        tokens_.fail(tokens_.peek().where, rsl2Message(construct));
    if (tokens_.at("}"))
        tokens_.fail(tokens_.peek().where, "'}' closes nothing; is there one too many above?");
    tokens_.unexpected("a shader (such as: surface name(...) {...}) or a function");
}

ast::Shader FileParser::shader() {
    Lookahead::InnerScope own(ahead_);
    ast::Shader result;
    result.doc = commentBefore(tokens_.peek().where);
    result.kind = *shaderKindNamed(tokens_.take().spelling);
    result.where = tokens_.peek().where;
    result.name = tokens_.take().spelling;
    result.parameters = declarations_.formals(result.name);
    attachComments(result.parameters, result.where.line);
    result.body = statements_.body("shader " + result.name);
    return result;
}

/// To the next line that starts a shader or a function, outside of braces.
void FileParser::recover() {
    tokens_.take();
    for (int depth = 0; !tokens_.atEnd(); tokens_.take()) {
        if (tokens_.peek().startsLine &&
            (ahead_.startsShader() || (depth <= 0 && ahead_.startsFunction())))
            return;
        depth += tokens_.at("{") - tokens_.at("}");
    }
}

} // namespace

ast::File parse(const std::vector<Token> &tokens, Reporter &reporter) {
    return FileParser(tokens, reporter).file();
}

} // namespace candela::sl
