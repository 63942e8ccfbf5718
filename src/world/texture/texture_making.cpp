// SPDX-License-Identifier: Apache-2.0
#include "world/texture/texture_making.h"

#include "world/texture/cube_faces.h"
#include "world/texture/module.h"

#include <algorithm>
#include <filesystem>

namespace candela {

namespace {

using Kind = TextureOrder::Kind;

/// What the numbers of the order's pictures are. Heights and depths are no colours.
PictureCurve curveOf(const TextureOrder &order) {
    if (order.kind == Kind::Bump || order.kind == Kind::Shadow)
        return PictureCurve::Linear;
    const Parameter *told = order.parameters.find("colorspace");
    const std::string space = told && !told->strings.empty() ? told->strings.front() : "";
    return space == "srgb"     ? PictureCurve::Srgb
           : space == "linear" ? PictureCurve::Linear
                               : PictureCurve::AsTold;
}

/// Of a depth picture the depths alone.
bool keepDepths(PictureData &picture, std::string &problem) {
    PictureFacts &facts = picture.facts;
    if (!facts.cameraFromWorld || !facts.frameFromWorld) {
        problem = "it does not say what camera has taken it: render it with a display of type "
                  "\"zfile\" or \"shadow\"";
        return false;
    }
    const auto channels = std::size_t(facts.channels);
    for (std::size_t i = 0; i * channels < picture.values.size(); ++i)
        picture.values[i] = picture.values[i * channels];
    picture.values.resize(picture.values.size() / channels);
    facts.channels = 1;
    facts.kind = PictureKind::Shadow;
    return true;
}

bool readAll(PictureLibrary &library, const TextureOrder &order, std::vector<PictureData> &pictures,
             std::string &problem) {
    for (const std::string &path : order.pictures)
        if (!library.read(path, curveOf(order), pictures.emplace_back(), problem)) {
            problem = path + " cannot be read: " + problem;
            return false;
        }
    return true;
}

/// The picture that is to be written.
std::optional<PictureData> prepared(const TextureOrder &order, std::vector<PictureData> &pictures,
                                    std::string &problem) {
    if (order.kind == Kind::CubeFaceEnvironment) {
        std::array<PictureData, 6> faces;
        std::move(pictures.begin(), pictures.end(), faces.begin());
        return latLongOfFaces(faces, order.fieldOfView, problem);
    }
    PictureData picture = std::move(pictures.front());
    picture.facts.kind = PictureKind::Texture;
    if (order.kind == Kind::LatLongEnvironment)
        picture.facts.kind = PictureKind::Environment;
    if (order.kind == Kind::Shadow && !keepDepths(picture, problem)) {
        problem = order.pictures.front() + ": " + problem;
        return std::nullopt;
    }
    return picture;
}

/// A picture is not to be lost to the texture made of it.
bool keepsPictures(const TextureOrder &order, std::string &problem) {
    for (const std::string &picture : order.pictures) {
        std::error_code isNew;
        if (std::filesystem::equivalent(picture, order.texture, isNew)) {
            problem = "the texture would take the place of " + picture + ", which it is made of";
            return false;
        }
    }
    return true;
}

} // namespace

bool makeTexture(const TextureOrder &order, std::string &problem) {
    if (!keepsPictures(order, problem))
        return false;
    PictureLibrary *library = pictureLibrary(problem);
    std::vector<PictureData> pictures;
    if (!library || !readAll(*library, order, pictures, problem))
        return false;
    const auto picture = prepared(order, pictures, problem);
    return picture && library->write(*picture, {order.sWrap, order.tWrap, order.filter},
                                     order.texture, problem);
}

} // namespace candela
