// SPDX-License-Identifier: Apache-2.0
#include "world/texture/module.h"

#include <dlfcn.h>
#include <filesystem>

namespace candela {

namespace {

struct Module {
    PictureLibrary *library = nullptr;
    std::string problem;
};

Module load() {
    std::error_code error;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::filesystem::path file =
        program.parent_path().parent_path() / "lib" / "candela" / "candela_pictures.so";
    void *module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    const auto function =
        module ? reinterpret_cast<PictureLibraryFunction>(dlsym(module, pictureLibraryFunction))
               : nullptr;
    if (!function)
        return {nullptr, std::string("the part of Candela that reads pictures cannot be loaded: ") +
                             dlerror()};
    PictureLibrary *library = function(pictureLibraryVersion);
    return {library, library ? "" : file.string() + " belongs to another version of Candela"};
}

} // namespace

PictureLibrary *pictureLibrary(std::string &problem) {
    static const Module module = load();
    problem = module.problem;
    return module.library;
}

} // namespace candela
