// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/files.h"

#include "world/texture/oiio/facts.h"
#include "world/texture/oiio/linear_input.h"

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <filesystem>
#include <unistd.h>

namespace candela {

namespace {

namespace fs = std::filesystem;

/// Values that a picture may have to be held whole: 4 GB.
constexpr double mostValues = 1 << 30;

OIIO::ImageSpec specOf(const PictureData &picture) {
    const PictureFacts &facts = picture.facts;
    OIIO::ImageSpec spec(facts.width, facts.height, facts.channels, OIIO::TypeDesc::FLOAT);
    if (facts.kind == PictureKind::Shadow) {
        spec.channelnames = {"Z"};
        spec.x = facts.left, spec.y = facts.top;
        spec.full_width = facts.frameWidth, spec.full_height = facts.frameHeight;
    }
    spec.attribute("oiio:ColorSpace", "Linear");
    tellFacts(facts, spec);
    return spec;
}

/// The names that our requests and OpenImageIO have for filters, where they differ.
std::string filterName(const std::string &name) {
    return name == "b-spline" ? "bspline" : name == "sinc" ? "lanczos3" : name;
}

/// Shadow maps are looked up by our own code, in one size.
bool writePlain(const PictureData &picture, const OIIO::ImageSpec &spec, const std::string &path,
                std::string &problem) {
    auto file = OIIO::ImageOutput::create("exr");
    const bool good = file && file->open(path, spec) &&
                      file->write_image(OIIO::TypeDesc::FLOAT, picture.values.data()) &&
                      file->close();
    if (!good)
        problem = file ? file->geterror() : OIIO::geterror();
    return good;
}

bool writeLevels(const PictureData &picture, const OIIO::ImageSpec &spec,
                 const TextureRecipe &recipe, const std::string &path, std::string &problem) {
    const OIIO::ImageBuf pixels(spec, const_cast<float *>(picture.values.data()));
    OIIO::ImageSpec wanted;
    tellFacts(picture.facts, wanted);
    wanted.format = OIIO::TypeDesc::HALF;
    wanted.attribute("wrapmodes", recipe.sWrap + "," + recipe.tWrap);
    wanted.attribute("maketx:fileformatname", "openexr");
    wanted.attribute("maketx:filtername", filterName(recipe.filter));
    wanted.attribute("compression", "zip");
    const bool good =
        OIIO::ImageBufAlgo::make_texture(OIIO::ImageBufAlgo::MakeTxTexture, pixels, path, wanted);
    if (!good)
        problem = OIIO::geterror();
    return good;
}

} // namespace

bool readPicture(const std::string &path, PictureCurve told, PictureData &picture,
                 std::string &problem) {
    const auto file = openPicture(path, problem);
    if (!file)
        return false;
    const OIIO::ImageSpec &spec = file->spec();
    picture.facts = factsOf(spec);
    const double values = double(spec.width) * spec.height * spec.nchannels;
    if (spec.depth > 1 || values < 1 || values > mostValues) {
        problem = "it is too large to be read";
        return false;
    }
    picture.values.resize(std::size_t(values));
    if (!file->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, picture.values.data())) {
        problem = file->geterror();
        return false;
    }
    const ColorCurve curve = curveOf(*file, path, told);
    makeLinear(curve, spec, spec.width * spec.height, picture.values.data());
    return true;
}

bool writePicture(const PictureData &picture, const TextureRecipe &recipe, const std::string &path,
                  std::string &problem) {
    const std::string unfinished = path + ".unfinished" + std::to_string(getpid());
    const OIIO::ImageSpec spec = specOf(picture);
    bool good = picture.facts.kind == PictureKind::Shadow
                    ? writePlain(picture, spec, unfinished, problem)
                    : writeLevels(picture, spec, recipe, unfinished, problem);
    std::error_code error;
    if (good)
        fs::rename(unfinished, path, error);
    if (error)
        problem = error.message(), good = false;
    if (!good)
        fs::remove(unfinished, error);
    return good;
}

} // namespace candela
