// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/linear_input.h"

#include "world/texture/oiio/claims.h"

namespace candela {

static const std::string prefix = "candela-linear:";

std::string linearName(const std::string &path) { return prefix + path; }

std::unique_ptr<OIIO::ImageInput> openPicture(const std::string &path, std::string &problem) {
    constexpr const char *tooMuch = "it claims more than can be in so small a file";
    if (hasImpossibleHeader(path)) {
        problem = tooMuch;
        return nullptr;
    }
    OIIO::ImageSpec asItStands;
    asItStands.attribute("oiio:UnassociatedAlpha", 1);
    auto file = OIIO::ImageInput::open(path, &asItStands);
    if (!file)
        problem = OIIO::geterror();
    else if (claimsTooMuch(*file, path)) {
        problem = tooMuch;
        file.reset();
    }
    return file;
}

bool LinearInput::open(const std::string &name, OIIO::ImageSpec &spec) {
    std::string problem;
    const std::string path = name.substr(name.starts_with(prefix) ? prefix.size() : 0);
    file_ = openPicture(path, problem);
    if (!file_) {
        errorfmt("{}", problem);
        return false;
    }
    curve_ = curveOf(*file_, path, PictureCurve::AsTold);
    describe();
    spec = m_spec;
    return true;
}

void LinearInput::describe() {
    m_spec = file_->spec();
    m_spec.set_format(OIIO::TypeDesc::HALF);
    m_spec.channelformats.clear();
    m_spec.attribute("oiio:ColorSpace", "Linear");
    m_spec.attribute("oiio:UnassociatedAlpha", 0);
}

bool LinearInput::close() {
    file_.reset();
    return true;
}

bool LinearInput::seek_subimage(int subimage, int miplevel) {
    if (!file_ || !file_->seek_subimage(subimage, miplevel))
        return false;
    describe();
    return true;
}

bool LinearInput::deliver(bool good, std::vector<float> &values, void *data) {
    if (!good) {
        errorfmt("{}", file_->geterror());
        return false;
    }
    const OIIO::ImageSpec &spec = file_->spec();
    makeLinear(curve_, spec, int(values.size()) / spec.nchannels, values.data());
    return OIIO::convert_pixel_values(OIIO::TypeDesc::FLOAT, values.data(), OIIO::TypeDesc::HALF,
                                      data, int(values.size()));
}

bool LinearInput::read_native_scanline(int subimage, int miplevel, int y, int z, void *data) {
    lock_guard lock(*this);
    if (!seek_subimage(subimage, miplevel))
        return false;
    const OIIO::ImageSpec &spec = file_->spec();
    std::vector<float> values(std::size_t(spec.width) * spec.nchannels);
    return deliver(file_->read_scanlines(subimage, miplevel, y, y + 1, z, 0, spec.nchannels,
                                         OIIO::TypeDesc::FLOAT, values.data()),
                   values, data);
}

bool LinearInput::read_native_tile(int subimage, int miplevel, int x, int y, int z, void *data) {
    lock_guard lock(*this);
    if (!seek_subimage(subimage, miplevel))
        return false;
    const OIIO::ImageSpec &spec = file_->spec();
    std::vector<float> values(std::size_t(spec.tile_pixels()) * spec.nchannels);
    return deliver(file_->read_tile(x, y, z, OIIO::TypeDesc::FLOAT, values.data()), values, data);
}

} // namespace candela
