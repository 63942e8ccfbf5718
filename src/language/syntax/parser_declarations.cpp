// SPDX-License-Identifier: Apache-2.0
// Variables, formals, functions, shaders.
#include <algorithm>

#include "language/syntax/parser_state.h"

namespace candela::sl {

bool Parser::startsDeclaration() const {
    if (atAny({"uniform", "varying", "extern"}))
        return true;
    return isTypeWord() && peek(1).isIdentifier() && !isReserved(1) && isName(1) && !at("(", 2);
}

// A definition is told from a call by what follows the brackets.
bool Parser::startsFunction() const {
    size_t name = isTypeWord() ? 1 : 0;
    if (!peek(name).isIdentifier() || isReserved(name) || isTypeWord(name) || !at("(", name + 1))
        return false;
    size_t behind = behindBrackets(name + 1);
    if (behind == 0)
        return false;
    return at("{", behind) ||
           (name == 1 && (isTypeWord(behind) || atAny({"uniform", "varying", "output"}, behind)));
}

bool Parser::startsSpecifier() const {
    return isTypeWord() || atAny({"uniform", "varying", "extern"}) ||
           (at("output") && peek(1).isIdentifier());
}

// [extern] [output] [uniform | varying] [output] type
ast::Variable Parser::specifiers() {
    ast::Variable result;
    while (true) {
        if (accept("extern"))
            result.external = true;
        else if (at("output") && peek(1).isIdentifier() && accept("output"))
            result.output = true;
        else if (accept("uniform"))
            result.detail = Detail::Uniform;
        else if (accept("varying"))
            result.detail = Detail::Varying;
        else
            break;
    }
    if (!isTypeWord())
        unexpected("a type (float, color, point, vector, normal, matrix, string)");
    result.type = *baseTypeNamed(peek().spelling);
    if (result.type == BaseType::Void)
        fail(peek().where, "a variable cannot be of type void");
    take();
    return result;
}

static ast::Variable sameKind(const ast::Variable &pattern) {
    ast::Variable result;
    result.type = pattern.type;
    result.detail = pattern.detail;
    result.output = pattern.output;
    result.external = pattern.external;
    return result;
}

ast::StmtPtr Parser::declaration() {
    ast::StmtPtr result = make(ast::StmtKind::Declare);
    ast::Variable pattern = specifiers();
    do {
        ast::Variable variable = sameKind(pattern);
        declarator(variable, false);
        result->variables.push_back(std::move(variable));
    } while (accept(","));
    expectSemicolon("after the declaration of " + result->variables.back().name);
    return result;
}

void Parser::declarator(ast::Variable &variable, bool isFormal) {
    variable.name = takeName("the name of a variable", variable.where);
    if (accept("[")) {
        variable.isArray = true;
        if (!at("]"))
            variable.length = expression();
        expect("]", "after the length of the array");
    }
    if (accept("="))
        initialiser(variable);
    if (baseTypeNamed(variable.name))
        namedAsTypes_.insert(variable.name);
    bool lengthless = variable.isArray && !variable.length && !variable.initialised;
    if (lengthless && !isFormal && !variable.external)
        fail(variable.where, "array " + variable.name + " needs a length or initial values");
}

void Parser::initialiser(ast::Variable &variable) {
    variable.initialised = true;
    variable.braced = accept("{");
    if (!variable.braced) {
        variable.initial.push_back(expression(Precedence::Choice));
        return;
    }
    while (!at("}")) {
        variable.initial.push_back(expression(Precedence::Choice));
        if (!accept(","))
            break;
    }
    expect("}", "or ',' in the initial values of " + variable.name);
}

std::vector<ast::Variable> Parser::formals(const std::string &owner) {
    expect("(", "after the name " + owner);
    std::vector<ast::Variable> result;
    ast::Variable pattern;
    bool typed = false;
    while (!atEnd() && !at(")") && !at("{")) {
        if (accept(";") || accept(","))
            continue;
        size_t start = at_;
        try {
            oneFormal(result, pattern, typed);
        } catch (Panic) {
            if (at_ == start)
                take();
            recoverInFormals();
        }
    }
    expect(")", "to close the parameters of " + owner);
    oldStyleFormals(result);
    return result;
}

void Parser::oneFormal(std::vector<ast::Variable> &list, ast::Variable &pattern, bool &typed) {
    if (startsSpecifier()) {
        pattern = specifiers();
        typed = true;
    }
    ast::Variable formal = sameKind(pattern);
    if (!typed)
        formal.type = BaseType::Void; // A bare name: its type follows before the body (RI 3.1).
    declarator(formal, true);
    list.push_back(std::move(formal));
    if (!atAny({";", ",", ")"})) {
        reporter_.error(afterPrevious(),
                        "expected ';', ',' or ')' after parameter " + list.back().name);
        recoverInFormals();
    }
}

void Parser::recoverInFormals() {
    for (int depth = 0; !atEnd() && !at("{") && !at("}"); take()) {
        if (depth == 0 && atAny({";", ",", ")"}))
            return;
        depth += at("(") - at(")");
    }
}

// surface name(a, b) float a = 1; color b = 0; { ... }
void Parser::oldStyleFormals(std::vector<ast::Variable> &list) {
    while (startsSpecifier()) {
        ast::Variable pattern = specifiers();
        do {
            ast::Variable formal = sameKind(pattern);
            declarator(formal, true);
            auto same = [&](const ast::Variable &v) { return v.name == formal.name; };
            auto known = std::ranges::find_if(list, same);
            if (known == list.end())
                fail(formal.where, formal.name + " is not in the list of parameters");
            *known = std::move(formal);
        } while (accept(","));
        expectSemicolon("after the declaration of a parameter");
    }
    for (ast::Variable &formal : list) {
        if (formal.type != BaseType::Void)
            continue;
        reporter_.error(formal.where, "parameter " + formal.name + " has no type");
        formal.type = BaseType::Float;
    }
}

ast::Function Parser::function() {
    DeclaredNames own(*this);
    ast::Function result;
    if (isTypeWord())
        result.result = baseTypeNamed(take().spelling);
    result.where = peek().where;
    result.name = take().spelling;
    result.formals = formals(result.name);
    if (!at("{"))
        unexpected("'{' to open the body of function " + result.name);
    result.body = block();
    return result;
}

bool Parser::startsShader(size_t ahead) const {
    return peek(ahead).isIdentifier() && shaderKindNamed(peek(ahead).spelling) &&
           peek(ahead + 1).isIdentifier() && at("(", ahead + 2);
}

ast::Shader Parser::shader() {
    DeclaredNames own(*this);
    ast::Shader result;
    result.doc = commentBefore(peek().where);
    result.kind = *shaderKindNamed(take().spelling);
    result.where = peek().where;
    result.name = take().spelling;
    result.parameters = formals(result.name);
    attachComments(result.parameters);
    if (!at("{"))
        unexpected("'{' to open the body of shader " + result.name);
    result.body = block();
    return result;
}

std::string Parser::commentBefore(const Place &where) const {
    if (where.file)
        for (const Comment &comment : where.file->comments)
            if (comment.lastLine < where.line && comment.lastLine >= where.line - 2)
                return comment.text;
    return {};
}

void Parser::attachComments(std::vector<ast::Variable> &list) const {
    auto onLine = [&](int line) {
        return std::ranges::any_of(list, [&](auto &v) { return v.where.line == line; });
    };
    for (ast::Variable &variable : list) {
        const SourceFile *file = variable.where.file;
        for (const Comment &comment : file->comments) {
            bool same = comment.firstLine == variable.where.line;
            bool above = comment.lastLine == variable.where.line - 1 && !onLine(comment.firstLine);
            if (same || (above && variable.doc.empty()))
                variable.doc = comment.text;
        }
    }
}

ast::File Parser::file() {
    ast::File result;
    while (!atEnd() && !reporter_.hopeless()) {
        try {
            if (accept(";"))
                continue;
            if (startsShader())
                result.items.emplace_back(shader());
            else if (startsFunction())
                result.items.emplace_back(function());
            else if (at("}"))
                fail(peek().where, "'}' closes nothing; is there one too many above?");
            else
                unexpected("a shader (such as: surface name(...) {...}) or a function");
        } catch (Panic) {
            recoverAtTop();
        }
    }
    return result;
}

// To the next line that starts a shader or a function, outside of braces.
void Parser::recoverAtTop() {
    take();
    for (int depth = 0; !atEnd(); take()) {
        if (peek().startsLine && (startsShader() || (depth <= 0 && startsFunction())))
            return;
        depth += at("{") - at("}");
    }
}

} // namespace candela::sl
