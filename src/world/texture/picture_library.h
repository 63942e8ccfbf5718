// SPDX-License-Identifier: Apache-2.0
// What the module that reads and writes pictures offers (oiio/, behind module.h). Nothing of
// OpenImageIO shows here.
#pragma once

#include "foundation/base/matrix4.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

enum class PictureKind { Texture, Environment, Shadow };

/// What a file says of itself.
struct PictureFacts {
    int width = 0, height = 0, channels = 0;
    PictureKind kind = PictureKind::Texture;
    /// Where it lies in a whole frame, of which it may be a part: its first column and row, and the
    /// frame's size in pixels.
    int left = 0, top = 0, frameWidth = 0, frameHeight = 0;
    /// Of pictures that a camera has taken: from world space to its space, and to its whole frame,
    /// on which x and y run from 0 (left, top) to 1. Row vectors.
    std::optional<Matrix4> cameraFromWorld, frameFromWorld;
};

/// A picture in memory: channels side by side, row by row from the top, linear light.
struct PictureData {
    PictureFacts facts;
    std::vector<float> values;
};

/// The operands of a lookup, in the order in which the service texture() has them.
enum class LookupOperand {
    s,
    t,
    dsdx,
    dtdx,
    dsdy,
    dtdy,
    sBlur,
    tBlur,
    channel,
    fill,
    sShift, ///< From s to the middle of the footprint.
    tShift
};
inline constexpr int lookupOperands = int(LookupOperand::tShift) + 1;

/// Lookups side by side. (s,t) is (0,0) at the upper left corner of the picture and (1,1) at the
/// lower right one.
struct LookupRow {
    int lanes = 0;
    std::uint32_t mask = 0;          ///< Bit j: lane j looks up.
    const float *operands = nullptr; ///< Operand k of lane j: operands[k * lanes + j].
    int values = 1;                  ///< Channels wanted: 1, or 3 as red, green and blue.
    bool slopes = false;             ///< The values' derivatives by s, then by t are wanted, too.
    bool around = false;             ///< s is periodic and t ends, whatever the file says.
    float *results = nullptr;        ///< Value k of lane j: results[k * lanes + j].
};

/// How 8-bit and other whole numbers become light.
enum class PictureCurve {
    AsTold, ///< By what the file says of itself; 8-bit colour of which it says nothing is sRGB.
    Linear,
    Srgb
};

/// How a texture is made.
struct TextureRecipe {
    std::string sWrap = "black", tWrap = "black"; ///< "black", "clamp", "periodic".
    std::string filter = "box";                   ///< By which smaller levels are made.
};

/// A picture that is to become the bytes of a file, as its numbers are.
struct PictureToEncode {
    enum class Format { Tiff, RadianceHdr };     ///< The latter holds three channels.
    enum class Numbers { Bytes, Words, Floats }; ///< Whole numbers up to 255 and 65535.
    Format format = Format::Tiff;
    Numbers numbers = Numbers::Bytes;
    int width = 0, height = 0;
    std::vector<std::string> channels; ///< Names: "R", "A", "Z"...
    std::vector<float> values;         ///< Channels side by side, row by row from the top.
    std::string description;
};

/// One in a process; all functions may be called from any thread.
class PictureLibrary {
public:
    struct Opened; ///< A picture to look things up in; never goes away.

    virtual ~PictureLibrary() = default;

    /// Null, and `problem` says why, if it is no picture.
    virtual const Opened *open(const std::string &path, PictureFacts &, std::string &problem) = 0;
    /// False, and zeros, where parts of the file cannot be read: `problem` says why.
    virtual bool look(const Opened &, const LookupRow &, std::string &problem) = 0;
    /// What files held may have changed. Nobody may be looking anything up.
    virtual void forget() = 0;
    /// Tiles of pictures that are kept in memory, in megabytes.
    virtual void limitMemory(int megabytes) = 0;

    /// Reads the whole picture.
    virtual bool read(const std::string &path, PictureCurve, PictureData &,
                      std::string &problem) = 0;
    /// Writes the picture with all smaller levels (a shadow map: as it is), whole or not at all.
    virtual bool write(const PictureData &, const TextureRecipe &, const std::string &path,
                       std::string &problem) = 0;
    /// The bytes depend on the picture alone.
    virtual bool encode(const PictureToEncode &, std::string &bytes, std::string &problem) = 0;
};

/// Changes with all that stands above: a module of another build is not taken.
inline constexpr int pictureLibraryVersion = 2;
/// The module's one function, of the name `pictureLibraryFunction`: null if it is of another
/// version.
using PictureLibraryFunction = PictureLibrary *(*)(int version);
inline constexpr const char *pictureLibraryFunction = "candelaPictureLibrary";

} // namespace candela
