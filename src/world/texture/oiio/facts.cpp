// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/facts.h"

#include <OpenImageIO/strutil.h>

#include <cstring>

namespace candela {

namespace {

/// Where our own files say what they are made for.
constexpr const char *kindAttribute = "candela:texture";
/// OpenEXR's worldToNDC, as OpenImageIO spells it.
constexpr const char *frameAttribute = "worldtoNDC";

PictureKind kindOf(const OIIO::ImageSpec &spec) {
    const std::string own = spec.get_string_attribute(kindAttribute);
    const std::string format = spec.get_string_attribute("textureformat");
    if (own == "environment" || OIIO::Strutil::icontains(format, "LatLong"))
        return PictureKind::Environment;
    if (own == "shadow" || OIIO::Strutil::icontains(format, "Shadow"))
        return PictureKind::Shadow;
    return PictureKind::Texture;
}

std::optional<Matrix4> matrixOf(const OIIO::ImageSpec &spec, const char *name) {
    const OIIO::ParamValue *found = spec.find_attribute(name);
    if (!found || found->type().basetype != OIIO::TypeDesc::FLOAT ||
        found->type().aggregate != OIIO::TypeDesc::MATRIX44)
        return std::nullopt;
    Matrix4 matrix;
    std::memcpy(matrix.m.data(), found->data(), 16 * sizeof(float));
    return matrix;
}

/// Others tell of screens on which x and y run from -1 (left, bottom) to 1.
std::optional<Matrix4> frameOf(const OIIO::ImageSpec &spec) {
    if (const auto frame = matrixOf(spec, frameAttribute))
        return frame;
    auto matrix = matrixOf(spec, "worldtoscreen");
    for (int row = 0; matrix && row < 4; ++row) {
        matrix->at(row, 0) = (matrix->at(row, 3) + matrix->at(row, 0)) / 2;
        matrix->at(row, 1) = (matrix->at(row, 3) - matrix->at(row, 1)) / 2;
    }
    return matrix;
}

void tellMatrix(const std::optional<Matrix4> &matrix, const char *name, OIIO::ImageSpec &spec) {
    if (matrix)
        spec.attribute(name, OIIO::TypeDesc::TypeMatrix, matrix->m.data());
}

} // namespace

PictureFacts factsOf(const OIIO::ImageSpec &spec) {
    PictureFacts facts{.width = spec.width,
                       .height = spec.height,
                       .channels = spec.nchannels,
                       .kind = kindOf(spec),
                       .left = spec.x - spec.full_x,
                       .top = spec.y - spec.full_y,
                       .frameWidth = spec.full_width,
                       .frameHeight = spec.full_height,
                       .cameraFromWorld = matrixOf(spec, "worldtocamera"),
                       .frameFromWorld = frameOf(spec)};
    return facts;
}

void tellFacts(const PictureFacts &facts, OIIO::ImageSpec &spec) {
    constexpr const char *names[] = {"texture", "environment", "shadow"};
    spec.attribute(kindAttribute, names[int(facts.kind)]);
    tellMatrix(facts.cameraFromWorld, "worldtocamera", spec);
    tellMatrix(facts.frameFromWorld, frameAttribute, spec);
}

} // namespace candela
