// SPDX-License-Identifier: Apache-2.0
// For tests: a sink that lists its calls, a line each, every float to the bit.
#pragma once

#include "interface/ri/stateless_sink.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

namespace candela::testing {

class ListingSink final : public StatelessSink {
public:
    std::string list, comments;

#define LISTED_ARGUMENT(type, name) add(name);
#define LISTED(Name, handler, ...)                                                                 \
    void handler(const SourceLocation &CANDELA_PARAMETERS(__VA_ARGS__)) override {                 \
        list += #Name;                                                                             \
        CANDELA_FOR_EACH(LISTED_ARGUMENT, __VA_ARGS__)                                             \
        list += '\n';                                                                              \
    }
#define REQUEST(Name, handler, scopes, ...) LISTED(Name, handler, __VA_ARGS__)
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...) LISTED(Name, handler, __VA_ARGS__)
#define REQUEST_OF_STREAM(Name, handler, scopes, ...) LISTED(Name, handler, __VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) LISTED(Name, handler, __VA_ARGS__)
#include "interface/ri/requests.def"
#undef LISTED
#undef LISTED_ARGUMENT

    void comment(const SourceLocation &, const std::string &text) override {
        comments += text + "\n";
    }
    bool wantsComments() const override { return true; }

private:
    /// One not-a-number is like another.
    void add(float value) {
        list +=
            std::isnan(value) ? " nan" : " " + std::to_string(std::bit_cast<std::uint32_t>(value));
    }
    void add(int value) { list += " i" + std::to_string(value); }
    void add(bool value) { list += value ? " true" : " false"; }
    void add(const std::string &text) { list += " \"" + text + "\""; }
    void add(const Handle &handle) { list += " handle " + handle.text; }
    void add(const Color &color) { addAll(color.c); }
    void add(const Matrix4 &matrix) { addAll(matrix.m); }
    void add(const BasisArgument &basis) {
        std::visit([&](const auto &value) { addAny(value); }, basis);
    }
    void add(const LooseFloats &loose) { addAll(loose.values); }
    void add(const SubdivisionTags &tags) {
        addAll(tags.names), addAll(tags.argumentCounts);
        addAll(tags.integers), addAll(tags.floats);
    }
    void add(const TokenList &parameters) {
        for (const TokenValue &parameter : parameters.all) {
            add(parameter.token);
            addAll(parameter.floats);
            addAll(parameter.strings);
            if (!parameter.integers.empty())
                addAll(parameter.integers);
        }
    }
    template <class Value> void add(const std::vector<Value> &values) { addAll(values); }

    void addAny(const std::string &text) { add(text); }
    template <class Values> void addAny(const Values &values) { addAll(values); }
    template <class Values> void addAll(const Values &values) {
        list += " [";
        for (const auto &value : values)
            add(value);
        list += " ]";
    }
};

} // namespace candela::testing
