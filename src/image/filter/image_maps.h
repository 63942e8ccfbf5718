// SPDX-License-Identifier: Apache-2.0
// The named maps that filter shaders read and write, as they stand between two filters.
#pragma once

#include "language/runtime/image_map.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// An image of some channels in memory: planes of rows with room on either side (imageHalo).
class OwnedImage {
public:
    enum class Contents { Black, Any };
    /// 0 < channels; width and height may be 0.
    OwnedImage(int width, int height, int channels, Contents = Contents::Black);
    /// Bytes that such an image takes.
    static double bytesNeeded(int width, int height, int channels);

    bool hasShapeOf(const OwnedImage &) const;
    /// All pixels of an image of the same shape.
    void takeValues(const OwnedImage &);

    const ImageMap &view() const { return view_; }
    int width() const { return view_.width; }
    int height() const { return view_.height; }
    int channels() const { return view_.channels; }
    float *row(int channel, int y) { return view_.row(channel, y); }
    const float *row(int channel, int y) const { return view_.row(channel, y); }

private:
    struct Free {
        void operator()(float *) const;
    };
    std::unique_ptr<float[], Free> memory_;
    std::vector<float *> planes_;
    ImageMap view_;
};

/// What is known of a map before it is there.
struct MapInfo {
    std::string name;
    int channels = 0;
};

/// Maps by name: "Ci" (the picture so far, which a filter reads as "Cs"), "Oi", "Z", "N", "albedo",
/// "variance", "id", other channels of the film, and what filters make for those after them.
class ImageMaps {
public:
    /// Null if there is none of that name.
    OwnedImage *find(const std::string &name);
    const OwnedImage *find(const std::string &name) const;
    /// Takes the place of a map of that name.
    OwnedImage &set(const std::string &name, OwnedImage);
    void remove(const std::string &name);
    std::vector<std::string> names() const;

    /// An image of that shape, of any contents: the one that was kept, if it will do. Memory that
    /// has been used costs nothing; the system takes longer to give new memory than filters to fill
    /// it.
    OwnedImage takeSpare(const OwnedImage &shape);
    void keepSpare(OwnedImage);

    /// Rows by columns of a channel from, and to, a plane without gaps.
    void setPlane(const std::string &name, int channel, std::span<const float> values);
    std::vector<float> plane(const std::string &name, int channel) const;

private:
    std::map<std::string, OwnedImage> maps_;
    std::optional<OwnedImage> spare_;
};

/// The mean of `count` planes, which `plane` gives one by one; count > 0.
std::vector<float> meanOfPlanes(int count, const std::function<std::vector<float>(int)> &plane);

} // namespace candela
