// SPDX-License-Identifier: Apache-2.0
#include "image/view/window_driver.h"

#include "foundation/base/module.h"

namespace candela {

std::unique_ptr<WindowDriver> openWindow(std::string &problem) {
    const auto function = reinterpret_cast<WindowOpenerFunction>(
        functionOfModule("candela_window", windowOpenerFunction, problem));
    const WindowOpener opener = function ? function(windowOpenerVersion) : nullptr;
    if (function && !opener)
        problem = "it belongs to another version of Candela";
    return opener ? opener(problem) : nullptr;
}

} // namespace candela
