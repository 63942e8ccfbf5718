// SPDX-License-Identifier: Apache-2.0
// The maps of filter shaders (paper, 6.2): image(), setimage(), setsize().
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_images.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/place_scope.h"

#include <algorithm>
#include <string_view>

namespace candela::ir {
namespace {

using runtime::ImageFilter;
using runtime::LookupOperand;

struct FilterName {
    std::string_view name;
    ImageFilter filter;
};
constexpr FilterName filterNames[] = {
    {"nearest", ImageFilter::Nearest},   {"bilinear", ImageFilter::Bilinear},
    {"box", ImageFilter::Box},           {"triangle", ImageFilter::Triangle},
    {"gaussian", ImageFilter::Gaussian}, {"catmull-rom", ImageFilter::CatmullRom}};

/// The map that a call names; an error where there are none.
std::string mapOf(BuiltinCall &call) {
    const std::string function = call.expr.overload->function->name;
    if (call.lowering.shader.kind != sl::ShaderKind::Filter)
        call.lowering.messages.error(call.expr.where,
                                     function + "() is for filter shaders: other shaders are given "
                                                "no picture");
    const std::string name =
        call.text(0, ("the name of the map that " + function + "() is about").c_str());
    const bool isPlain = std::ranges::none_of(name, [](unsigned char c) { return c < ' '; });
    if (!call.lowering.messages.failed() && (name.empty() || !isPlain))
        call.lowering.messages.error(call.expr.operands[0]->where,
                                     "a map has a name of one character or more, none of them a "
                                     "control character");
    return name;
}

/// What may stand behind the coordinates of image().
struct LookupOptions {
    ImageFilter filter = ImageFilter::Bilinear;
    ValueId channel, xWidth, yWidth;
};

class OptionReader {
public:
    explicit OptionReader(BuiltinCall &call) : call_(call) {
        const ValueId two = number(call.b, 2);
        options_ = {ImageFilter::Bilinear, number(call.b, 0), two, two};
    }

    LookupOptions read() {
        for (size_t k = 3; k < call_.count(); k += 2) {
            const std::string name = call_.isText(k) ? call_.text(k, "a parameter's name") : "";
            if (name.empty() || k + 1 >= call_.count())
                fault(k, "behind the coordinates of image() come names of parameters, each with "
                         "its value");
            else
                take(name, k + 1);
        }
        return options_;
    }

private:
    void fault(size_t argument, const std::string &problem) {
        call_.lowering.messages.error(call_.expr.operands[argument]->where, problem);
    }
    void take(const std::string &name, size_t value) {
        if (name == "filter")
            return takeFilter(value);
        if (call_.expr.operands[value]->type.base != sl::BaseType::Float)
            return fault(value, "\"" + name + "\" takes a float");
        const ValueId given = call_.number(value);
        if (name == "channel")
            options_.channel = given;
        else if (name == "sample")
            options_.channel =
                mul(call_.b, given, number(call_.b, float(call_.b.colors().samples)));
        else if (name == "width")
            options_.xWidth = options_.yWidth = given;
        else if (name == "xwidth")
            options_.xWidth = given;
        else if (name == "ywidth")
            options_.yWidth = given;
        else
            fault(value - 1, "image() has no parameter \"" + name +
                                 "\"; it has \"channel\", \"sample\", \"filter\", \"width\", "
                                 "\"xwidth\" and \"ywidth\"");
    }
    void takeFilter(size_t value) {
        const std::string name =
            call_.isText(value) ? call_.text(value, "the name of a filter") : "";
        std::string known;
        for (const FilterName &each : filterNames) {
            known += (known.empty() ? "" : ", ") + std::string(each.name);
            if (each.name == name) {
                options_.filter = each.filter;
                return;
            }
        }
        fault(value, "image() has no filter \"" + name + "\"; it has " + known);
    }

    BuiltinCall &call_;
    LookupOptions options_;
};

Components image(BuiltinCall &call) {
    const std::string map = mapOf(call);
    const LookupOptions options = OptionReader(call).read();
    const int values = componentCount(call.b, call.result());
    const PlaceScope place(call.b, call.expr.where);
    return imageLoad(
        call.b, map, values, options.filter,
        {call.number(1), call.number(2), options.channel, options.xWidth, options.yWidth});
}

/// "Cs" is what comes in.
std::string mapToSet(BuiltinCall &call) {
    const std::string map = mapOf(call);
    if (map == "Cs")
        call.lowering.messages.error(call.expr.operands[0]->where,
                                     "the map \"Cs\" is what the filter is given, and stays as it "
                                     "is; what it makes of it goes to \"Ci\"");
    return map;
}

Components setimage(BuiltinCall &call) {
    const std::string map = mapToSet(call);
    const PlaceScope place(call.b, call.expr.where);
    imageStore(call.b, map, call.number(1), call.number(2), call.arguments[3]);
    return {};
}

Components setsize(BuiltinCall &call) {
    const std::string map = mapToSet(call);
    intern(call.b.function().maps, map);
    const PlaceScope place(call.b, call.expr.where);
    command(call.b, info(Service::setsize), {map}, {call.number(1), call.number(2)});
    return {};
}

} // namespace

BuiltinLowering imageBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::image: return image;
    case sl::BuiltinId::setimage: return setimage;
    case sl::BuiltinId::setsize: return setsize;
    default: return nullptr;
    }
}

} // namespace candela::ir
