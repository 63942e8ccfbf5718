// SPDX-License-Identifier: Apache-2.0
#include "image/filter/filter_run.h"

#include "image/filter/bound_maps.h"
#include "image/filter/pixel_loop_run.h"

namespace candela {

namespace {

/// What a running filter calls.
struct Context {
    const FilterCode &filter;
    BoundMaps &maps;
    FilterWatch &watch;
};

Context &contextOf(void *pointer) { return *static_cast<Context *>(pointer); }

/// The filter's own services pass on to those of all shaders.
template <Service service> void passOn(void *context, const ServiceCall &call) {
    const ShaderServices &all = contextOf(context).filter.services();
    all.functions[std::size_t(service)](all.context, call);
}

ShaderServices servicesOf(Context &context) {
    ShaderServices services;
    services.context = &context;
    services[Service::print] = passOn<Service::print>;
    services[Service::option] = passOn<Service::option>;
    services[Service::texture] = passOn<Service::texture>;
    services[Service::environment] = passOn<Service::environment>;
    services[Service::textureinfo] = passOn<Service::textureinfo>;
    services[Service::setsize] = [](void *pointer, const ServiceCall &call) {
        contextOf(pointer).maps.resize(call.site->texts[0], call.operand(0, 0).number,
                                       call.operand(1, 0).number, *call.site);
    };
    return services;
}

ShaderCallbacks callbacksOf(Context &context) {
    ShaderCallbacks callbacks;
    callbacks.context = &context;
    callbacks.indexOutside = [](void *pointer, const char *file, std::int32_t line) {
        const ShaderCallbacks &all = contextOf(pointer).filter.callbacks();
        all.indexOutside(all.context, file, line);
    };
    callbacks.serviceAbsent = [](void *pointer, const char *service, const char *file,
                                 std::int32_t line) {
        const ShaderCallbacks &all = contextOf(pointer).filter.callbacks();
        all.serviceAbsent(all.context, service, file, line);
    };
    callbacks.goOn = [](void *pointer) {
        const Context &context = contextOf(pointer);
        return !context.maps.failed() && context.watch.goesOn();
    };
    return callbacks;
}

} // namespace

void runFilter(const FilterCode &filter, ImageMaps &all, FilterWatch &watch,
               DiagnosticSink &diagnostics) {
    const OwnedImage *given = all.find("Ci");
    if (!given || given->width() == 0 || given->height() == 0)
        return;
    BoundMaps maps(filter.driver(), all, diagnostics);
    if (!maps.bind())
        return;
    const float facts[int(PictureFact::Count)] = {float(given->width()), float(given->height())};
    PixelLoopRun loops(filter, maps, watch);
    Context context{filter, maps, watch};
    const ShaderServices services = servicesOf(context);
    const ShaderCallbacks callbacks = callbacksOf(context);
    const PixelLoopRunner runner = loops.runner();

    ShaderArgs args;
    args.count = 1;
    args.inputs = PixelLoopRun::noInputs();
    args.maps = maps.views();
    args.captured = facts;
    args.pixelLoops = &runner;
    args.callbacks = &callbacks;
    args.services = &services;
    loops.bind(args);
    filter.run(args);
    if (!watch.isInterrupted() && !maps.failed())
        maps.handOver();
}

} // namespace candela
