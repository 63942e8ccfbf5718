// SPDX-License-Identifier: Apache-2.0
#include "image/filter/filter_run.h"

#include "foundation/base/parallel.h"
#include "image/filter/pixel_loop_run.h"
#include "language/ir/core/regions.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace candela {

// --- FilterWatch ---------------------------------------------------------------------------------

void FilterWatch::begin(const std::string &filter, int done) {
    filter_ = filter;
    done_ = done;
    progress(-1);
}

/// True some times a second.
bool FilterWatch::isTime() {
    using namespace std::chrono;
    constexpr std::int64_t interval = 100'000'000; // Nanoseconds.
    const std::int64_t now = steady_clock::now().time_since_epoch() / 1ns;
    std::int64_t next = nextTime_;
    return now >= next && nextTime_.compare_exchange_strong(next, now + interval);
}

void FilterWatch::progress(double part) {
    if (!isTime())
        return;
    std::lock_guard lock(mutex_);
    if (listeners_.progress)
        listeners_.progress(filter_, done_, part);
    if (listeners_.interrupted && listeners_.interrupted())
        interrupted_ = true;
}

bool FilterWatch::goesOn() {
    progress(-1);
    return !interrupted_;
}

// --- A filter ------------------------------------------------------------------------------------

namespace {

/// Maps that setsize() makes, or that a filter makes by setting them, may have so many numbers.
constexpr double mostNumbers = 1 << 30;

/// What a map's number stands for while a filter runs.
class BoundMaps {
public:
    BoundMaps(const ir::Function &driver, ImageMaps &maps, DiagnosticSink &diagnostics)
        : driver_(driver), maps_(maps), diagnostics_(diagnostics), black_(1, 1, colorSamples),
          views_(driver.maps.size(), black_.view()) {}

    /// False if the filter cannot run with the maps that are there.
    bool bind();
    const ImageMap *views() const { return views_.data(); }
    /// setsize(): a black image of that size takes the place of the map.
    void resize(const std::string &name, float width, float height, const ServiceSite &);
    /// "Ci" is what the filter has made of it.
    void handOver();

private:
    struct Uses {
        bool isRead = false, isSet = false, isSetWhole = false;
        int channels = 0; ///< The most that are set at a time.
        const ir::Instruction *read = nullptr, *set = nullptr;
    };
    std::vector<Uses> uses() const;
    void add(std::vector<Uses> &, const ir::Function &) const;
    bool bindOwn(std::size_t number, const Uses &);
    bool fits(const std::string &map, const OwnedImage &, const Uses &);
    SourceLocation placeOf(const ir::Instruction &) const;

    const ir::Function &driver_;
    ImageMaps &maps_;
    DiagnosticSink &diagnostics_;
    OwnedImage black_; ///< What maps show that are not there.
    std::optional<OwnedImage> picture_;
    std::vector<ImageMap> views_;
};

SourceLocation BoundMaps::placeOf(const ir::Instruction &i) const {
    SourceLocation where;
    if (!driver_.files.empty())
        where.file = std::make_shared<const std::string>(driver_.files[std::size_t(i.file)]);
    where.line = i.line;
    return where;
}

void BoundMaps::add(std::vector<Uses> &uses, const ir::Function &function) const {
    ir::forEachInstruction(function.body, [&](const ir::Instruction &i) {
        if (i.op != ir::Op::ImageLoad && i.op != ir::Op::ImageStore)
            return;
        const ir::ImageUse &use = function.images[std::size_t(i.immediate)];
        Uses &map = uses[std::size_t(use.map)];
        if (i.op == ir::Op::ImageLoad) {
            map.isRead = true;
            map.read = map.read ? map.read : &i;
        } else {
            map.isSet = true;
            map.channels = std::max(map.channels, use.values);
            map.set = map.set && map.channels > use.values ? map.set : &i;
        }
    });
}

std::vector<BoundMaps::Uses> BoundMaps::uses() const {
    std::vector<Uses> uses(driver_.maps.size());
    add(uses, driver_);
    for (const ir::PixelLoop &loop : driver_.pixelLoops)
        add(uses, *loop.body);
    return uses;
}

bool BoundMaps::fits(const std::string &map, const OwnedImage &image, const Uses &use) {
    if (use.channels <= 1 || use.channels == image.channels())
        return true;
    diagnostics_.error(placeOf(*use.set),
                       fmt::format("the map \"{}\" has {} channel{}, but is set to a color here; "
                                   "the filter \"{}\" is left out",
                                   map, image.channels(), image.channels() == 1 ? "" : "s",
                                   driver_.name));
    return false;
}

/// Others than "Cs" and "Ci".
bool BoundMaps::bindOwn(std::size_t number, const Uses &use) {
    const std::string &name = driver_.maps[number];
    OwnedImage *image = maps_.find(name);
    if (!image && use.isSet)
        image = &maps_.set(name, OwnedImage(picture_->width(), picture_->height(), use.channels));
    if (image) {
        views_[number] = image->view();
        return fits(name, *image, use);
    }
    if (use.isRead) {
        std::string known = "Cs, Ci";
        for (const std::string &each : maps_.names())
            known += each == "Ci" ? "" : ", " + each;
        diagnostics_.error(placeOf(*use.read), fmt::format("there is no map \"{}\"; it is read as "
                                                           "black. There are {}",
                                                           name, known));
    }
    return true;
}

bool BoundMaps::bind() {
    const std::vector<Uses> all = uses();
    const OwnedImage &given = *maps_.find("Ci");
    picture_ = given.copy();
    bool good = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string &name = driver_.maps[k];
        if (name == "Cs")
            views_[k] = given.view();
        else if (name == "Ci")
            views_[k] = picture_->view(), good &= fits(name, *picture_, all[k]);
        else
            good &= bindOwn(k, all[k]);
    }
    for (ImageMap &view : views_)
        if (view.width == 0 || view.height == 0)
            view = black_.view();
    return good;
}

void BoundMaps::resize(const std::string &name, float width, float height,
                       const ServiceSite &site) {
    const auto at = std::find(driver_.maps.begin(), driver_.maps.end(), name);
    const float w = std::floor(width + .5f), h = std::floor(height + .5f);
    const OwnedImage *before = name == "Ci" ? &*picture_ : maps_.find(name);
    const int channels = before ? before->channels() : colorSamples;
    if (!(w >= 1 && h >= 1 && double(w) * double(h) * channels <= mostNumbers)) {
        SourceLocation where{std::make_shared<const std::string>(site.file), site.line};
        diagnostics_.error(where, fmt::format("setsize(): the map \"{}\" cannot have {} x {} "
                                              "pixels; it stays as it is",
                                              name, width, height));
        return;
    }
    OwnedImage made(int(w), int(h), channels);
    const OwnedImage &kept =
        name == "Ci" ? picture_.emplace(std::move(made)) : maps_.set(name, std::move(made));
    views_[std::size_t(at - driver_.maps.begin())] = kept.view();
}

void BoundMaps::handOver() { maps_.set("Ci", std::move(*picture_)); }

/// What a running filter calls.
struct Context {
    const FilterCode &filter;
    BoundMaps &maps;
    FilterWatch &watch;
    PixelLoopRun &loops;
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
    callbacks.goOn = [](void *pointer) { return contextOf(pointer).watch.goesOn(); };
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
    PixelLoopRun loops(filter, watch);
    Context context{filter, maps, watch, loops};
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
    if (!watch.isInterrupted())
        maps.handOver();
}

} // namespace candela
