// SPDX-License-Identifier: Apache-2.0
// What a user does to a window.
#pragma once

#include <string>

namespace candela {

struct ViewEvent {
    enum class Kind {
        Key,     ///< `key`: "+", "r", "page up", "escape"...
        Pointer, ///< It is at x, y now.
        Drag,    ///< By x, y, with a button held.
        Wheel,   ///< y steps, away from the user.
        Resize,  ///< To x, y.
        Expose,  ///< It is to be painted again.
        Close,
    };
    Kind kind;
    int x = 0, y = 0;
    std::string key{};
};

} // namespace candela
