// SPDX-License-Identifier: Apache-2.0
// The maps of a filter while it runs, by the numbers that its code has for them.
#pragma once

#include "foundation/base/diagnostics.h"
#include "image/filter/image_maps.h"
#include "language/ir/core/ir.h"
#include "language/runtime/services.h"

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// What a map's number stands for while a filter runs.
class BoundMaps {
public:
    BoundMaps(const ir::Function &driver, ImageMaps &maps, DiagnosticSink &diagnostics)
        : driver_(driver), maps_(maps), diagnostics_(diagnostics), black_(1, 1, colorSamples),
          views_(driver.maps.size(), black_.view()), halos_(driver.maps.size(), Halos::Wanted) {}

    /// False if the filter cannot run with the maps that are there.
    bool bind();
    const ImageMap *views() const { return views_.data(); }
    /// setsize(): a black image of that size takes the place of the map. One that cannot be had is
    /// reported, and the filter is left out.
    void resize(const std::string &name, float width, float height, const ServiceSite &);
    /// Before a pixel loop that runs over `columns` x `rows` pixels from (0, 0) on, or (0 x 0) over
    /// others: what it leaves as it is of "Ci" must be there.
    void prepare(const ir::PixelLoop &, std::int64_t columns, std::int64_t rows);
    /// Whether what lies beyond a map's border (imageHalo) is not what the border holds.
    bool wantsHalos(int map) const { return halos_[std::size_t(map)] != Halos::Filled; }
    void noteHalosFilled(int map);
    /// A pixel loop has set maps.
    void noteSet(const ir::PixelLoop &);
    /// The filter is not to go on, and leaves the picture as it is.
    bool failed() const { return failed_; }
    /// "Ci" is what the filter has made of it.
    void handOver();

private:
    /// What is set outside of pixel loops changes without a word.
    enum class Halos { Changing, Wanted, Filled };
    struct Uses {
        bool isRead = false, isSet = false, isSized = false;
        bool isSerial = false;    ///< Outside of pixel loops, too.
        bool isSetSerial = false; ///< Likewise.
        int channels = 0;         ///< The most that are set at a time.
        const ir::Instruction *read = nullptr, *set = nullptr;
    };
    std::vector<Uses> uses() const;
    void takePicture(const OwnedImage &given, bool isSerial);
    void fillPicture();
    bool bindOwn(std::size_t number, const Uses &);
    bool fits(const std::string &map, const OwnedImage &, const Uses &);
    SourceLocation placeOf(const ir::Instruction &) const;
    /// The driver is named for its question: "ward94.filter".
    std::string filterName() const { return driver_.name.substr(0, driver_.name.rfind('.')); }

    const ir::Function &driver_;
    ImageMaps &maps_;
    DiagnosticSink &diagnostics_;
    OwnedImage black_;                  ///< What maps show that are not there.
    std::optional<OwnedImage> picture_; ///< "Ci".
    int pictureNumber_ = -1;            ///< Among the driver's maps.
    bool isFilled_ = false;             ///< Pixels that are not set hold what was given.
    std::atomic<bool> failed_{false};
    std::vector<ImageMap> views_;
    std::vector<Halos> halos_; ///< Of each map.
};

} // namespace candela
