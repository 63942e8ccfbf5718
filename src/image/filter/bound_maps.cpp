// SPDX-License-Identifier: Apache-2.0
#include "image/filter/bound_maps.h"

#include "image/filter/image_uses.h"
#include "language/ir/core/op_info.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace candela {

namespace {

/// Maps that setsize() makes may have so many numbers.
constexpr double mostNumbers = 1 << 30;

} // namespace

SourceLocation BoundMaps::placeOf(const ir::Instruction &i) const {
    SourceLocation where;
    if (!driver_.files.empty())
        where.file = std::make_shared<const std::string>(driver_.files[std::size_t(i.file)]);
    where.line = i.line;
    return where;
}

/// The map that setsize() is about.
static std::size_t mapOfSize(const ir::Function &function, const ir::Instruction &i) {
    const std::string &name = function.strings[std::size_t(serviceOf(function, i).texts[0])];
    return std::size_t(std::ranges::find(function.maps, name) - function.maps.begin());
}

std::vector<BoundMaps::Uses> BoundMaps::uses() const {
    std::vector<Uses> uses(driver_.maps.size());
    ir::forEachInstruction(driver_.body, [&](const ir::Instruction &i) { // Never in pixel loops.
        if (i.op == ir::Op::Command && serviceOf(driver_, i).info->service == Service::setsize)
            uses[mapOfSize(driver_, i)].isSized = true;
    });
    forEachImageUse(driver_, [&](const MapAccess &access) {
        const ir::Instruction &i = access.instruction;
        Uses &map = uses[std::size_t(access.use.map)];
        map.isSerial |= access.isSerial;
        if (i.op == ir::Op::ImageLoad) {
            map.isRead = true;
            map.read = map.read ? map.read : &i;
        } else {
            map.isSet = true;
            map.isSetSerial |= access.isSerial;
            map.channels = std::max(map.channels, access.use.values);
            map.set = map.set && map.channels > access.use.values ? map.set : &i;
        }
    });
    return uses;
}

bool BoundMaps::fits(const std::string &map, const OwnedImage &image, const Uses &use) {
    if (use.channels <= 1 || use.channels == image.channels())
        return true;
    diagnostics_.error(placeOf(*use.set),
                       fmt::format("the map \"{}\" has {} channel{}, but is set to a color here; "
                                   "the filter \"{}\" is left out",
                                   map, image.channels(), image.channels() == 1 ? "" : "s",
                                   filterName()));
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
    if (use.isRead && !use.isSized) {
        std::string known = "Cs, Ci";
        for (const std::string &each : maps_.names())
            known += each == "Ci" ? "" : ", " + each;
        diagnostics_.error(placeOf(*use.read), fmt::format("there is no map \"{}\"; it is read as "
                                                           "black. There are {}",
                                                           name, known));
    }
    return true;
}

/// Memory is taken as it is where all of it is going to be set.
void BoundMaps::takePicture(const OwnedImage &given, bool isSerial) {
    picture_ = maps_.takeSpare(given);
    if (isSerial)
        fillPicture();
}

void BoundMaps::fillPicture() {
    picture_->takeValues(*maps_.find("Ci"));
    isFilled_ = true;
}

void BoundMaps::prepare(const ir::PixelLoop &loop, std::int64_t columns, std::int64_t rows) {
    const auto has = [&](const std::vector<int> &list) {
        return std::find(list.begin(), list.end(), pictureNumber_) != list.end();
    };
    if (isFilled_ || (!has(loop.mapsRead) && !has(loop.mapsSet)))
        return;
    const bool isWhole = columns >= picture_->width() && rows >= picture_->height();
    if (isWhole && has(loop.mapsCovered))
        isFilled_ = true;
    else
        fillPicture();
}

bool BoundMaps::bind() {
    const std::vector<Uses> all = uses();
    const OwnedImage &given = *maps_.find("Ci");
    const auto named = std::find(driver_.maps.begin(), driver_.maps.end(), "Ci");
    pictureNumber_ = named == driver_.maps.end() ? -1 : int(named - driver_.maps.begin());
    takePicture(given, pictureNumber_ >= 0 && all[std::size_t(pictureNumber_)].isSerial);
    bool good = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string &name = driver_.maps[k];
        if (name == "Cs")
            views_[k] = given.view();
        else if (int(k) == pictureNumber_)
            views_[k] = picture_->view(), good &= fits(name, *picture_, all[k]);
        else
            good &= bindOwn(k, all[k]);
    }
    for (std::size_t k = 0; k < all.size(); ++k)
        halos_[k] = all[k].isSetSerial ? Halos::Changing : Halos::Wanted;
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
        diagnostics_.error(
            where, fmt::format("setsize(): the map \"{}\" cannot have {} x {} pixels (1 to {} "
                               "numbers are allowed); the filter is left out",
                               name, width, height, mostNumbers));
        failed_ = true;
        return;
    }
    OwnedImage made(int(w), int(h), channels);
    OwnedImage &kept =
        name == "Ci" ? picture_.emplace(std::move(made)) : maps_.set(name, std::move(made));
    isFilled_ |= name == "Ci";
    const std::size_t number = std::size_t(at - driver_.maps.begin());
    views_[number] = kept.view();
    halos_[number] = halos_[number] == Halos::Changing ? Halos::Changing : Halos::Wanted;
}

void BoundMaps::noteHalosFilled(int map) {
    Halos &halos = halos_[std::size_t(map)];
    halos = halos == Halos::Changing ? halos : Halos::Filled;
}

void BoundMaps::noteSet(const ir::PixelLoop &loop) {
    for (const int map : loop.mapsSet)
        if (Halos &halos = halos_[std::size_t(map)]; halos == Halos::Filled)
            halos = Halos::Wanted;
}

void BoundMaps::handOver() {
    if (!isFilled_)
        std::swap(*picture_, *maps_.find("Ci")); // It has set nothing.
    maps_.keepSpare(std::move(*maps_.find("Ci")));
    maps_.set("Ci", std::move(*picture_));
}

} // namespace candela
