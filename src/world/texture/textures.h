// SPDX-License-Identifier: Apache-2.0
// The pictures that running shaders look things up in, by name: found and opened when they are
// first asked for. What is missing or no picture is warned of once and gives zeros.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/options.h"
#include "language/runtime/services.h"
#include "world/texture/picture_library.h"
#include "world/texture/shadow_map.h"

#include <map>
#include <memory>
#include <shared_mutex>
#include <string>
#include <vector>

namespace candela {

/// Answers from any thread; bind() from one, while nobody asks.
class Textures {
public:
    /// `folders` are searched behind those of Option "searchpath" "texture".
    Textures(std::vector<std::string> folders, DiagnosticSink &);
    ~Textures();
    Textures(const Textures &) = delete;
    Textures &operator=(const Textures &) = delete;

    /// The options of the frame to come: where textures are, what space the camera is in. What was
    /// opened before is looked for anew, since a frame may write what the next one reads.
    void bind(const Options &);

    /// False for a shadow map that is to be had from rays instead: one that is not there, and what
    /// PRMan calls "raytrace".
    bool hasShadowMap(const std::string &name) const;

    /// The services of these names (language/runtime/services.def).
    void texture(const ServiceCall &);
    void environment(const ServiceCall &);
    void shadow(const ServiceCall &);
    void textureinfo(const ServiceCall &);

private:
    /// A name and what it has turned out to be.
    struct Texture {
        std::string path; ///< Empty: there is none.
        PictureFacts facts;
        const PictureLibrary::Opened *picture = nullptr; ///< Null: nothing to be looked up.
        std::unique_ptr<ShadowMap> shadow;               ///< Of those that shadow() has asked for.
        bool isDamaged = false;                          ///< It has been warned of.
    };
    enum class Use { Pixels, Depths };
    Texture &find(const ServiceCall &, const char *name, Use);
    void open(Texture &, const ServiceCall &, const std::string &name, Use);
    void openPixels(Texture &, const ServiceCall &, const std::string &name);
    void openDepths(Texture &, const ServiceCall &, const std::string &name);
    void lookPixels(Texture &, const ServiceCall &);
    void lookAround(Texture &, const ServiceCall &);
    void lookDepths(const Texture &, const ServiceCall &) const;
    void tellFact(const Texture &, const ServiceCall &) const;
    void look(Texture &, const ServiceCall &, const LookupRow &);
    void warn(const ServiceCall &, const std::string &name, const std::string &message);
    /// Loads the module if that is still to be done; false after an error, which is reported once.
    bool hasLibrary();

    const std::vector<std::string> moreFolders_;
    DiagnosticSink &diagnostics_;
    std::vector<std::string> folders_;
    Matrix4 worldFromCurrent_;
    float shadowBias_ = -1;
    int megabytes_ = 0; ///< 0 = the library's own.
    std::shared_mutex mutex_;
    /// By name and use.
    std::map<std::pair<std::string, Use>, std::unique_ptr<Texture>, std::less<>> textures_;
    PictureLibrary *pictures_ = nullptr; ///< The module, once something has been asked of it.
    bool hasFailed_ = false;             ///< It cannot be had.
    unsigned generation_ = 0;
};

/// A fact that textureinfo() tells, if it has this type ("float[2]"); empty if there is none.
std::vector<float> textureFact(const PictureFacts &, bool exists, std::string_view fact,
                               std::string_view type);

} // namespace candela
