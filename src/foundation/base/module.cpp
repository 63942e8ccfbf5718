// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/module.h"

#include "foundation/base/installation.h"

#include <dlfcn.h>

namespace candela {

void *functionOfModule(const std::string &name, const char *function, std::string &problem) {
    const std::string file = "lib/candela/" + name + ".so";
    const auto path = installedPath(file);
    if (!path) {
        problem = "there is no " + file + " around the program";
        return nullptr;
    }
    void *const module = dlopen(path->c_str(), RTLD_NOW | RTLD_LOCAL);
    void *const found = module ? dlsym(module, function) : nullptr;
    if (!found)
        problem = dlerror();
    return found;
}

} // namespace candela
