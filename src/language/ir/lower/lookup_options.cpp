// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/lookup_options.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

#include <algorithm>
#include <string_view>

namespace candela::ir {

namespace {

/// Which of the options a name sets. `channel` is the checker's word for name[channel].
struct OptionName {
    std::string_view name;
    std::initializer_list<ValueId LookupOptions::*> sets;
};
using Options = LookupOptions;
const OptionName optionNames[] = {
    {"channel", {&Options::channel}},
    {"width", {&Options::sWidth, &Options::tWidth}},
    {"swidth", {&Options::sWidth}},
    {"twidth", {&Options::tWidth}},
    {"blur", {&Options::sBlur, &Options::tBlur}},
    {"sblur", {&Options::sBlur}},
    {"tblur", {&Options::tBlur}},
    {"fill", {&Options::fill}},
    {"samples", {&Options::samples}},
    {"bias", {&Options::bias}},
};

/// Parameters of other renderers that choose how, and not what, is looked up: there is one way
/// here.
constexpr std::string_view passedOver[] = {"filter",     "lerp",      "expandwidth", "mipinterp",
                                           "mapname",    "minfilter", "maxfilter",   "resolution",
                                           "samplebase", "gapbias"};

class OptionReader {
public:
    explicit OptionReader(BuiltinCall &call) : call_(call) {
        Builder &b = call.b;
        const ValueId none = number(b, 0), one = number(b, 1);
        options_ = {none, one, one, none, none, none, number(b, 16), number(b, -1)};
    }

    LookupOptions read() {
        for (size_t k = firstOption(call_); k < call_.count(); k += 2) {
            const std::string name = call_.isText(k) ? call_.text(k, "a parameter's name") : "";
            if (name.empty() || k + 1 >= call_.count())
                fault(k, function() + "() has names of parameters behind its coordinates, each "
                                      "with its value");
            else if (name == "source")
                k = lastOfSource(k);
            else
                take(name, k + 1);
        }
        return options_;
    }

private:
    std::string function() const { return call_.expr.overload->function->name; }
    /// The light that a map was made for may be told by its corners. The map itself says where it
    /// stood, and what it hides from there.
    size_t lastOfSource(size_t name) const {
        size_t corner = name + 1;
        while (corner + 1 < call_.count() && isPoint(corner) && isPoint(corner + 1))
            ++corner;
        return corner - 1;
    }
    bool isPoint(size_t argument) const {
        return sl::isGeometric(call_.expr.operands[argument]->type.base);
    }
    void fault(size_t argument, const std::string &problem) {
        call_.lowering.messages.error(call_.expr.operands[argument]->where, problem);
    }
    void take(const std::string &name, size_t value) {
        const auto known = std::ranges::find(optionNames, name, &OptionName::name);
        if (known == std::end(optionNames)) {
            if (std::ranges::find(passedOver, name) == std::end(passedOver))
                call_.lowering.messages.warning(call_.expr.operands[value - 1]->where,
                                                function() + "() has no parameter \"" + name +
                                                    "\"; it is passed over");
            return;
        }
        if (call_.expr.operands[value]->type.base != sl::BaseType::Float)
            return fault(value, "\"" + name + "\" takes a float");
        for (ValueId LookupOptions::*option : known->sets)
            options_.*option = call_.number(value);
    }

    BuiltinCall &call_;
    LookupOptions options_;
};

} // namespace

size_t firstOption(const BuiltinCall &call) { return call.firstText(1); }

LookupOptions readLookupOptions(BuiltinCall &call) { return OptionReader(call).read(); }

} // namespace candela::ir
