// SPDX-License-Identifier: Apache-2.0
#include "world/texture/module.h"

#include "foundation/base/module.h"

namespace candela {

namespace {

struct Module {
    PictureLibrary *library = nullptr;
    std::string problem;
};

Module load() {
    std::string problem;
    const auto function = reinterpret_cast<PictureLibraryFunction>(
        functionOfModule("candela_pictures", pictureLibraryFunction, problem));
    PictureLibrary *const library = function ? function(pictureLibraryVersion) : nullptr;
    if (function && !library)
        problem = "it belongs to another version of Candela";
    if (!library)
        problem = "the part of Candela that reads pictures cannot be loaded: " + problem;
    return {library, problem};
}

} // namespace

PictureLibrary *pictureLibrary(std::string &problem) {
    static const Module module = load();
    problem = module.problem;
    return module.library;
}

} // namespace candela
