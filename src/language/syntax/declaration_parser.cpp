// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/declaration_parser.h"

#include "language/syntax/rsl2.h"

#include <algorithm>

namespace candela::sl {

// [extern] [output] [uniform | varying] [output] type
ast::Variable DeclarationParser::specifiers() {
    ast::Variable result;
    while (true) {
        if (tokens_.accept("extern"))
            result.external = true;
        else if (tokens_.at("output") && tokens_.peek(1).isIdentifier() && tokens_.accept("output"))
            result.output = true;
        else if (tokens_.accept("uniform"))
            result.detail = Detail::Uniform;
        else if (tokens_.accept("varying"))
            result.detail = Detail::Varying;
        else
            break;
    }
    if (const std::string construct = rsl2Construct(tokens_); !construct.empty())
        tokens_.fail(tokens_.peek().where, rsl2Message(construct));
    if (!ahead_.isTypeWord())
        tokens_.unexpected("a type (float, color, point, vector, normal, matrix, string)");
    result.type = *baseTypeNamed(tokens_.peek().spelling);
    if (result.type == BaseType::Void)
        tokens_.fail(tokens_.peek().where, "a variable cannot be of type void");
    tokens_.take();
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

std::vector<ast::Variable> DeclarationParser::variables() {
    std::vector<ast::Variable> result;
    ast::Variable pattern = specifiers();
    do {
        ast::Variable variable = sameKind(pattern);
        declarator(variable, false);
        result.push_back(std::move(variable));
    } while (tokens_.accept(","));
    tokens_.expectSemicolon("after the declaration of " + result.back().name);
    return result;
}

void DeclarationParser::declarator(ast::Variable &variable, bool isFormal) {
    if (!ahead_.isName())
        tokens_.unexpected("the name of a variable");
    variable.where = tokens_.peek().where;
    variable.name = tokens_.take().spelling;
    if (tokens_.accept("[")) {
        variable.isArray = true;
        if (!tokens_.at("]"))
            variable.length = expressions_.expression();
        tokens_.expect("]", "after the length of the array");
    }
    if (tokens_.accept("="))
        initialiser(variable, isFormal ? Precedence::Choice : Precedence::Assignment);
    ahead_.declare(variable.name);
    bool lengthless = variable.isArray && !variable.length && !variable.initialised;
    if (lengthless && !isFormal && !variable.external)
        tokens_.fail(variable.where, "array " + variable.name +
                                         " needs a length or initial values; an array "
                                         "that grows is of RSL 2.0, which Candela does "
                                         "not support");
}

void DeclarationParser::initialiser(ast::Variable &variable, Precedence least) {
    variable.initialised = true;
    variable.braced = tokens_.accept("{");
    if (!variable.braced) {
        variable.initial.push_back(expressions_.expression(least));
        return;
    }
    while (!tokens_.at("}")) {
        variable.initial.push_back(expressions_.expression(Precedence::Choice));
        if (!tokens_.accept(","))
            break;
    }
    tokens_.expect("}", "or ',' in the initial values of " + variable.name);
}

std::vector<ast::Variable> DeclarationParser::formals(const std::string &owner) {
    tokens_.expect("(", "after the name " + owner);
    std::vector<ast::Variable> result;
    ast::Variable pattern;
    bool typed = false;
    if (tokens_.at("void") && tokens_.at(")", 1))
        tokens_.take(); // f(void), as in C.
    while (!tokens_.atEnd() && !tokens_.at(")") && !tokens_.at("{")) {
        if (tokens_.accept(";") || tokens_.accept(","))
            continue;
        size_t start = tokens_.position();
        try {
            oneFormal(result, pattern, typed);
        } catch (Panic) {
            if (tokens_.position() == start)
                tokens_.take();
            recoverInFormals();
        }
    }
    tokens_.expect(")", "to close the parameters of " + owner);
    oldStyleFormals(result);
    return result;
}

void DeclarationParser::oneFormal(std::vector<ast::Variable> &list, ast::Variable &pattern,
                                  bool &typed) {
    if (ahead_.startsSpecifier()) {
        pattern = specifiers();
        typed = true;
    }
    ast::Variable formal = sameKind(pattern);
    if (!typed)
        formal.type = BaseType::Void; // A bare name: its type follows before the body (RI 3.1).
    declarator(formal, true);
    list.push_back(std::move(formal));
    if (!tokens_.atAny({";", ",", ")"})) {
        tokens_.reporter().error(tokens_.afterPrevious(),
                                 "expected ';', ',' or ')' after parameter " + list.back().name);
        recoverInFormals();
    }
}

void DeclarationParser::recoverInFormals() {
    for (int depth = 0; !tokens_.atEnd() && !tokens_.at("{") && !tokens_.at("}"); tokens_.take()) {
        if (depth == 0 && tokens_.atAny({";", ",", ")"}))
            return;
        depth += tokens_.at("(") - tokens_.at(")");
    }
}

// surface name(a, b) float a = 1; color b = 0; { ... }
void DeclarationParser::oldStyleFormals(std::vector<ast::Variable> &list) {
    while (ahead_.startsSpecifier()) {
        ast::Variable pattern = specifiers();
        do {
            ast::Variable formal = sameKind(pattern);
            declarator(formal, true);
            auto same = [&](const ast::Variable &v) { return v.name == formal.name; };
            auto known = std::ranges::find_if(list, same);
            if (known == list.end())
                tokens_.fail(formal.where, formal.name + " is not in the list of parameters");
            *known = std::move(formal);
        } while (tokens_.accept(","));
        tokens_.expectSemicolon("after the declaration of a parameter");
    }
    for (ast::Variable &formal : list) {
        if (formal.type != BaseType::Void)
            continue;
        tokens_.reporter().error(formal.where, "parameter " + formal.name + " has no type");
        formal.type = BaseType::Float;
    }
}

} // namespace candela::sl
