// SPDX-License-Identifier: Apache-2.0
#include "world/texture/textures.h"

#include "interface/ri/search_path.h"
#include "world/texture/lat_long.h"
#include "world/texture/module.h"
#include "world/texture/texture_files.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <mutex>

namespace candela {

namespace {

/// PRMan's name for shadows without a map.
constexpr const char *tracedShadows = "raytrace";

/// Rows of a block are no wider (contracts.md, 7).
constexpr int mostLanes = 32;

/// Every Textures and every frame has a number of its own, so that threads may keep what they have
/// found.
std::atomic<unsigned> generations{0};

std::string listOf(const std::vector<std::string> &folders) {
    std::string all;
    for (const std::string &folder : folders)
        all += (all.empty() ? "" : ", ") + folder;
    return all;
}

/// What "Option shadow" says of it; below 0 where it says nothing.
float shadowBiasOf(const Options &options) {
    const float low = options.named.number("shadow:bias0", -1);
    const float high = options.named.number("shadow:bias1", low);
    return options.named.number("shadow:bias", low < 0 ? -1 : (low + high) / 2);
}

Vec3 triple(const ServiceCall &call, int first, int lane) {
    return {call.operand(first, lane).number, call.operand(first + 1, lane).number,
            call.operand(first + 2, lane).number};
}

} // namespace

Textures::Textures(std::vector<std::string> folders, DiagnosticSink &diagnostics)
    : moreFolders_(std::move(folders)), diagnostics_(diagnostics), folders_(moreFolders_),
      generation_(++generations) {}

Textures::~Textures() = default;

void Textures::bind(const Options &options) {
    folders_ = searchFolders(options, "texture");
    for (const std::string &folder : moreFolders_)
        if (std::ranges::find(folders_, folder) == folders_.end())
            folders_.push_back(folder);
    worldFromCurrent_ = inverse(options.camera.cameraFromWorld).value_or(Matrix4{});
    shadowBias_ = shadowBiasOf(options);
    megabytes_ = int(options.named.number("limits:texturememory", 0) / 1024);
    generation_ = ++generations;
    if (textures_.empty())
        return;
    textures_.clear();
    if (pictures_)
        pictures_->forget();
}

bool Textures::hasShadowMap(const std::string &name) const {
    return name != tracedShadows && findTexture(name, folders_);
}

bool Textures::hasLibrary() {
    if (pictures_ || hasFailed_)
        return pictures_ != nullptr;
    std::string problem;
    pictures_ = pictureLibrary(problem);
    hasFailed_ = !pictures_;
    if (hasFailed_)
        diagnostics_.error({}, problem + "; all textures are black");
    return pictures_ != nullptr;
}

void Textures::warn(const ServiceCall &call, const std::string &name, const std::string &message) {
    const SourceLocation where{std::make_shared<const std::string>(call.site->file),
                               call.site->line, 0};
    diagnostics_.warning(call.site->line > 0 ? where : SourceLocation{},
                         "texture \"" + name + "\": " + message);
}

Textures::Texture &Textures::find(const ServiceCall &call, const char *name, Use use) {
    struct Known {
        unsigned generation = 0;
        Use use = Use::Pixels;
        std::string name;
        Texture *texture = nullptr;
    };
    thread_local std::array<Known, 1024> known;
    const std::uint64_t mixed = std::uintptr_t(name) * 0x9e3779b97f4a7c15u;
    Known &last = known[(mixed >> 32) % known.size()];
    if (last.generation == generation_ && last.use == use && last.name == name)
        return *last.texture;
    const std::scoped_lock lock(mutex_);
    auto &texture = textures_[{name, use}];
    if (!texture) {
        texture = std::make_unique<Texture>();
        open(*texture, call, name, use);
    }
    last = {generation_, use, name, texture.get()};
    return *texture;
}

namespace {

/// Calls `answer` for each name by which lanes ask, with their part of the call.
template <class Answer> void forEachName(const ServiceCall &call, Answer answer) {
    const auto nameOf = [&](int lane) {
        return call.operand(call.site->operandCount - 1, lane).integer;
    };
    ServiceCall part = call;
    for (std::uint32_t rest = call.mask; rest != 0; rest &= ~part.mask) {
        const int first = std::countr_zero(rest);
        part.mask = rest;
        if (!call.hasOneText())
            for (int lane = first; lane < call.laneCount; ++lane)
                if (nameOf(lane) != nameOf(first))
                    part.mask &= ~(1u << lane);
        answer(call.text(first), part);
    }
}

} // namespace

void Textures::open(Texture &texture, const ServiceCall &call, const std::string &name, Use use) {
    if (name.empty())
        return;
    if (use == Use::Depths && name == tracedShadows)
        return;
    const auto found = findTexture(name, folders_);
    if (!found)
        return warn(call, name,
                    "there is no such file in " + listOf(folders_) +
                        (use == Use::Depths ? "; lights that ask for it have their shadows by rays"
                                            : "; what is looked up in it is 0"));
    if (!found->isExact)
        warn(call, name, "there is no such file; " + found->path + " is taken in its place");
    if (!hasLibrary())
        return;
    if (megabytes_ > 0)
        pictures_->limitMemory(megabytes_);
    texture.path = found->path;
    use == Use::Pixels ? openPixels(texture, call, name) : openDepths(texture, call, name);
}

void Textures::openPixels(Texture &texture, const ServiceCall &call, const std::string &name) {
    std::string problem;
    texture.picture = pictures_->open(texture.path, texture.facts, problem);
    if (!texture.picture)
        warn(call, name,
             texture.path + " cannot be read: " + problem + "; what is looked up in it is 0");
}

void Textures::openDepths(Texture &texture, const ServiceCall &call, const std::string &name) {
    PictureData picture;
    std::string problem;
    auto map = pictures_->read(texture.path, PictureCurve::Linear, picture, problem)
                   ? ShadowMap::of(std::move(picture), problem)
                   : std::nullopt;
    if (map)
        texture.shadow = std::make_unique<ShadowMap>(std::move(*map));
    else
        warn(call, name, texture.path + " cannot be used: " + problem + "; it hides nothing");
}

void Textures::look(Texture &texture, const ServiceCall &call, const LookupRow &row) {
    std::string problem;
    if (pictures_->look(*texture.picture, row, problem))
        return;
    const std::scoped_lock lock(mutex_);
    if (!texture.isDamaged)
        warn(call, call.text(std::countr_zero(call.mask)),
             texture.path + " is damaged: " + problem + "; what cannot be read is 0");
    texture.isDamaged = true;
}

void Textures::lookPixels(Texture &texture, const ServiceCall &call) {
    if (!texture.picture)
        return;
    static_assert(sizeof(ServiceCell) == sizeof(float));
    const bool slopes = call.site->service == Service::textureSlopes;
    look(texture, call,
         {call.laneCount, call.mask, reinterpret_cast<const float *>(call.operands),
          slopes ? call.site->resultCount / (1 + twinCoordinates) : call.site->resultCount, slopes,
          false, call.results});
}

void Textures::lookAround(Texture &texture, const ServiceCall &call) {
    if (!texture.picture)
        return;
    float operands[lookupOperands * mostLanes];
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        const PlaceReach at =
            latLongPlace({triple(call, 0, lane), triple(call, 3, lane), triple(call, 6, lane)},
                         texture.facts.width);
        const float row[lookupOperands] = {at.s,
                                           at.t,
                                           at.dsdx,
                                           at.dtdx,
                                           at.dsdy,
                                           at.dtdy,
                                           call.operand(9, lane).number,
                                           call.operand(10, lane).number,
                                           call.operand(11, lane).number,
                                           call.operand(12, lane).number,
                                           0,
                                           0};
        for (int k = 0; k < lookupOperands; ++k)
            operands[k * call.laneCount + lane] = row[k];
    }
    look(texture, call,
         {call.laneCount, call.mask, operands, call.site->resultCount, false, true, call.results});
}

void Textures::lookDepths(const Texture &texture, const ServiceCall &call) const {
    if (!texture.shadow)
        return;
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        const float bias = call.operand(11, lane).number;
        const float samples = call.operand(12, lane).number;
        call.result(0, lane) = texture.shadow->hidden(
            {transformPoint(worldFromCurrent_, triple(call, 0, lane)),
             transformVector(worldFromCurrent_, triple(call, 3, lane)),
             transformVector(worldFromCurrent_, triple(call, 6, lane))},
            call.operand(9, lane).number, call.operand(10, lane).number,
            bias < 0 ? shadowBias_ : bias, samples >= 1 && samples < 1024 ? int(samples) : 1024);
    }
}

void Textures::tellFact(const Texture &texture, const ServiceCall &call) const {
    const std::vector<float> fact = textureFact(texture.facts, texture.picture != nullptr,
                                                call.site->texts[1], call.site->texts[2]);
    if (fact.size() + 1 != std::size_t(call.site->resultCount))
        return;
    for (int lane = 0; lane < call.laneCount; ++lane) {
        if (!call.asks(lane))
            continue;
        call.result(0, lane) = 1;
        for (std::size_t k = 0; k < fact.size(); ++k)
            call.result(int(k) + 1, lane) = fact[k];
    }
}

void Textures::texture(const ServiceCall &call) {
    forEachName(call, [this](const char *name, const ServiceCall &part) {
        lookPixels(find(part, name, Use::Pixels), part);
    });
}

void Textures::environment(const ServiceCall &call) {
    forEachName(call, [this](const char *name, const ServiceCall &part) {
        lookAround(find(part, name, Use::Pixels), part);
    });
}

void Textures::shadow(const ServiceCall &call) {
    forEachName(call, [this](const char *name, const ServiceCall &part) {
        lookDepths(find(part, name, Use::Depths), part);
    });
}

void Textures::textureinfo(const ServiceCall &call) {
    forEachName(call, [this](const char *name, const ServiceCall &part) {
        tellFact(find(part, name, Use::Pixels), part);
    });
}

} // namespace candela
