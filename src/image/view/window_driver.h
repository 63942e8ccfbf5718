// SPDX-License-Identifier: Apache-2.0
// A window of the screen, as the module that knows of screens gives it: one at a time, and all
// calls from one thread.
#pragma once

#include "image/view/view_event.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace candela {

class WindowDriver {
public:
    virtual ~WindowDriver() = default;
    /// Of that size, or as large as the screen lets it be; a Resize event tells. Before, it is not
    /// seen.
    virtual void reveal(int width, int height) = 0;
    virtual void setTitle(const std::string &) = 0;
    /// 0xRRGGBB, row by row, over all of the window.
    virtual void show(std::span<const std::uint32_t> pixels, int width, int height) = 0;
    /// What the user has done; waits no longer than that for it.
    virtual std::optional<ViewEvent> wait(int milliseconds) = 0;
    /// Whether anybody could see it.
    virtual bool hasOnlooker() const = 0;
};

/// Null, and `problem` says why, if there is no screen.
using WindowOpener = std::unique_ptr<WindowDriver> (*)(std::string &problem);

/// The module's function: gives its opener, or null if it is asked for another version of this.
inline constexpr const char *windowOpenerFunction = "candelaWindowOpener";
inline constexpr int windowOpenerVersion = 1;
using WindowOpenerFunction = WindowOpener (*)(int version);

/// Opens one by the module, which is loaded for it.
std::unique_ptr<WindowDriver> openWindow(std::string &problem);

} // namespace candela
