// SPDX-License-Identifier: Apache-2.0
// Reads the signatures of builtins.def into overloads, once.
#include "language/semantics/builtins.h"

#include <cctype>
#include <map>

namespace candela::sl {
namespace {

struct Row {
    BuiltinId id;
    const char *name;
    Available available;
    Lowering lowering;
    Uniformity uniformity;
    Derivative derivative;
    Bounding bound;
    const char *types;
    const char *signatures;
    const char *doc;
};

constexpr Row rows[] = {
#define SL_BUILTIN(name, when, lowering, uniformity, derivative, bound, types, signatures, doc)    \
    {BuiltinId::name,                                                                              \
     #name,                                                                                        \
     Available::when,                                                                              \
     Lowering::lowering,                                                                           \
     Uniformity::uniformity,                                                                       \
     Derivative::derivative,                                                                       \
     Bounding::bound,                                                                              \
     types,                                                                                        \
     signatures,                                                                                   \
     doc},
#include "language/semantics/builtins.def"
#undef SL_BUILTIN
};

/// Words and single punctuation marks of a signature; "..." and "[]" are words too.
std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> result;
    for (size_t i = 0; i < text.size();) {
        size_t end = i;
        while (end < text.size() && std::isalnum((unsigned char)text[end]))
            ++end;
        if (end == i)
            end = text.substr(i, 3) == "..." ? i + 3 : text.substr(i, 2) == "[]" ? i + 2 : i + 1;
        if (text[i] != ' ')
            result.emplace_back(text.substr(i, end - i));
        i = end;
    }
    return result;
}

class SignatureReader {
public:
    SignatureReader(const std::vector<std::string> &words, BaseType generic)
        : words_(words), generic_(generic) {}

    /// The overload that starts at word `at`; moves `at` behind its ';'.
    BuiltinOverload read(size_t &at) {
        at_ = at;
        BuiltinOverload result;
        result.result = type(next());
        next(); // (
        while (word() != ")") {
            if (accept("..."))
                result.openEnded = true;
            else
                result.parameters.push_back(parameter(result));
            accept(",");
        }
        next();
        accept(";");
        at = at_;
        return result;
    }

private:
    std::string word() const { return at_ < words_.size() ? words_[at_] : ")"; }
    std::string next() {
        std::string result = word();
        ++at_;
        return result;
    }
    bool accept(std::string_view expected) {
        bool found = at_ < words_.size() && words_[at_] == expected;
        at_ += found;
        return found;
    }
    BaseType type(const std::string &word) const {
        return word == "T" ? generic_ : baseTypeNamed(word).value_or(BaseType::Void);
    }

    BuiltinParameter parameter(BuiltinOverload &overload) {
        BuiltinParameter result;
        result.output = accept("output");
        result.uniform = accept("uniform");
        result.anyType = accept("any");
        result.proper = accept("proper");
        if (!result.anyType)
            result.type = type(next());
        result.name = next();
        result.array = accept("[]");
        overload.repeatsLast |= accept("...");
        return result;
    }

    const std::vector<std::string> &words_;
    BaseType generic_;
    size_t at_ = 0;
};

std::vector<BuiltinOverload> overloadsOf(const Row &row) {
    std::vector<BuiltinOverload> result;
    std::vector<std::string> words = wordsOf(row.signatures);
    std::vector<std::string> generics = wordsOf(row.types);
    for (size_t at = 0; at < words.size();) {
        size_t start = at;
        BuiltinOverload plain = SignatureReader(words, BaseType::Float).read(at);
        bool generic = false;
        for (size_t i = start; i < at; ++i)
            generic |= words[i] == "T";
        if (!generic)
            result.push_back(std::move(plain));
        for (size_t i = 0; generic && i < generics.size(); ++i) {
            size_t again = start;
            result.push_back(SignatureReader(words, *baseTypeNamed(generics[i])).read(again));
        }
    }
    return result;
}

struct Table {
    std::vector<Builtin> functions;
    std::map<std::string, const Builtin *, std::less<>> byName;

    Table() {
        for (const Row &row : rows)
            functions.push_back({row.id, row.name, row.available, row.lowering, row.uniformity,
                                 row.derivative, row.bound, row.doc, overloadsOf(row)});
        for (Builtin &function : functions) {
            byName[function.name] = &function;
            for (size_t i = 0; i < function.overloads.size(); ++i) {
                function.overloads[i].function = &function;
                function.overloads[i].index = int(i);
            }
        }
    }
};

const Table &table() {
    static const Table result;
    return result;
}

} // namespace

std::string BuiltinOverload::signature() const {
    std::string list;
    for (const BuiltinParameter &p : parameters) {
        list += list.empty() ? "" : ", ";
        list += p.output ? "output " : p.uniform ? "uniform " : "";
        list += std::string(p.anyType ? "any" : nameOf(p.type)) + " " + p.name;
        list += p.array ? "[]" : "";
    }
    if (repeatsLast || openEnded)
        list += list.empty() || repeatsLast ? "..." : ", ...";
    return std::string(nameOf(result)) + " " + function->name + "(" + list + ")";
}

std::span<const Builtin> builtins() { return table().functions; }

const Builtin &builtin(BuiltinId id) { return table().functions[size_t(id)]; }

const Builtin *findBuiltin(std::string_view name) {
    auto found = table().byName.find(name);
    return found == table().byName.end() ? nullptr : found->second;
}

} // namespace candela::sl
