// SPDX-License-Identifier: Apache-2.0
// The module's one door: OpenImageIO's texture system and files behind PictureLibrary.
#include "world/texture/oiio/encode.h"
#include "world/texture/oiio/facts.h"
#include "world/texture/oiio/files.h"
#include "world/texture/oiio/guard.h"
#include "world/texture/oiio/linear_input.h"
#include "world/texture/oiio/lookups.h"

#include <OpenImageIO/imagecache.h>

#include <deque>
#include <mutex>

namespace candela {

namespace {

class Library final : public PictureLibrary {
public:
    Library()
        : cache_(OIIO::ImageCache::create(false)),
          system_(OIIO::TextureSystem::create(false, cache_)) {
        system_->attribute("accept_untiled", 1);
        system_->attribute("accept_unmipped", 1);
        system_->attribute("automip", 1);
        system_->attribute("autotile", 0); // Whole pictures: formats are read from their beginning.
        system_->attribute("max_open_files", 200);
    }

    const Opened *open(const std::string &path, PictureFacts &facts,
                       std::string &problem) override {
        return guarded(problem, [&] { return openForLookups(path, facts, problem); });
    }
    bool look(const Opened &picture, const LookupRow &row, std::string &problem) override {
        return guarded(problem, [&] {
            const bool good = lookUp(*system_, picture, row);
            if (!good)
                problem = system_->geterror();
            return good;
        });
    }
    void forget() override { system_->invalidate_all(true); }
    void limitMemory(int megabytes) override {
        system_->attribute("max_memory_MB", float(megabytes));
    }
    bool read(const std::string &path, PictureCurve curve, PictureData &picture,
              std::string &problem) override {
        return guarded(problem, [&] { return readPicture(path, curve, picture, problem); });
    }
    bool write(const PictureData &picture, const TextureRecipe &recipe, const std::string &path,
               std::string &problem) override {
        return guarded(problem, [&] { return writePicture(picture, recipe, path, problem); });
    }
    bool encode(const PictureToEncode &picture, std::string &bytes, std::string &problem) override {
        return guarded(problem, [&] { return encodePicture(picture, bytes, problem); });
    }

private:
    const Opened *openForLookups(const std::string &path, PictureFacts &facts,
                                 std::string &problem) {
        const auto file = openPicture(path, problem);
        if (!file)
            return nullptr;
        facts = factsOf(file->spec());
        const bool isLight = curveOf(*file, path, PictureCurve::AsTold).isLinear();
        const OIIO::ustring name(isLight ? path : linearName(path));
        const std::scoped_lock lock(mutex_);
        if (!isLight)
            cache_->add_file(
                name, [] { return static_cast<OIIO::ImageInput *>(new LinearInput); }, nullptr,
                true);
        const bool saysWrap = file->spec().find_attribute("wrapmodes") != nullptr;
        Opened opened{system_->get_texture_handle(name), facts.channels, saysWrap};
        if (!opened.handle || !system_->good(opened.handle)) {
            problem = system_->geterror();
            return nullptr;
        }
        return &opened_.emplace_back(opened);
    }

    OIIO::ImageCache *const cache_;
    OIIO::TextureSystem *const system_;
    std::mutex mutex_;
    std::deque<Opened> opened_;
};

} // namespace

} // namespace candela

extern "C" candela::PictureLibrary *candelaPictureLibrary(int version) {
    // Never destroyed: OpenImageIO's own statics may be gone first.
    static candela::Library *const library = new candela::Library;
    return version == candela::pictureLibraryVersion ? library : nullptr;
}
