// SPDX-License-Identifier: Apache-2.0
// A module of its own, so that SDL is loaded when there is something to show: a window by SDL 2.
#include "image/view/window_driver.h"

#include <SDL.h>
#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace candela {

namespace {

/// Of keys that make no character; those come as text, wherever they are on a keyboard.
std::string nameOf(SDL_Keycode key) {
    return key == SDLK_ESCAPE     ? "escape"
           : key == SDLK_PAGEUP   ? "page up"
           : key == SDLK_PAGEDOWN ? "page down"
                                  : "";
}

class SdlWindow final : public WindowDriver {
public:
    explicit SdlWindow(SDL_Window *window) : window_(window) {}
    ~SdlWindow() override {
        SDL_DestroyWindow(window_);
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }

    void reveal(int width, int height) override {
        SDL_Rect screen{0, 0, width, height};
        SDL_GetDisplayUsableBounds(0, &screen);
        SDL_SetWindowSize(window_, std::min(width, screen.w), std::min(height, screen.h));
        SDL_ShowWindow(window_);
    }

    void setTitle(const std::string &title) override { SDL_SetWindowTitle(window_, title.c_str()); }

    void show(std::span<const std::uint32_t> pixels, int width, int height) override {
        SDL_Surface *const to = SDL_GetWindowSurface(window_);
        SDL_Surface *const from =
            SDL_CreateRGBSurfaceWithFormatFrom(const_cast<std::uint32_t *>(pixels.data()), width,
                                               height, 32, 4 * width, SDL_PIXELFORMAT_RGB888);
        if (to && from)
            SDL_BlitSurface(from, nullptr, to, nullptr);
        SDL_FreeSurface(from);
        SDL_UpdateWindowSurface(window_);
    }

    std::optional<ViewEvent> wait(int milliseconds) override {
        SDL_Event event;
        if (SDL_WaitEventTimeout(&event, milliseconds) == 0)
            return std::nullopt;
        return translated(event);
    }

    bool hasOnlooker() const override {
        const char *const driver = SDL_GetCurrentVideoDriver();
        return driver &&
               (std::string_view(driver) == "x11" || std::string_view(driver) == "wayland");
    }

private:
    static std::optional<ViewEvent> translated(const SDL_Event &event) {
        using Kind = ViewEvent::Kind;
        switch (event.type) {
        case SDL_QUIT: return ViewEvent{Kind::Close};
        case SDL_KEYDOWN: return ViewEvent{Kind::Key, 0, 0, nameOf(event.key.keysym.sym)};
        case SDL_TEXTINPUT: return ViewEvent{Kind::Key, 0, 0, event.text.text};
        case SDL_MOUSEWHEEL: return ViewEvent{Kind::Wheel, 0, event.wheel.y};
        case SDL_MOUSEMOTION:
            if (event.motion.state != 0)
                return ViewEvent{Kind::Drag, event.motion.xrel, event.motion.yrel};
            return ViewEvent{Kind::Pointer, event.motion.x, event.motion.y};
        case SDL_WINDOWEVENT:
            if (event.window.event == SDL_WINDOWEVENT_SIZE_CHANGED)
                return ViewEvent{Kind::Resize, event.window.data1, event.window.data2};
            if (event.window.event == SDL_WINDOWEVENT_EXPOSED)
                return ViewEvent{Kind::Expose};
            return std::nullopt;
        default: return std::nullopt;
        }
    }

    SDL_Window *const window_;
};

/// The kinds of screens that the environment tells of. SDL by itself would take what nobody sees.
std::string screens() {
    const auto isSet = [](const char *variable) {
        const char *const value = std::getenv(variable);
        return value && *value;
    };
    if (isSet("SDL_VIDEODRIVER"))
        return std::getenv("SDL_VIDEODRIVER");
    std::string kinds = isSet("WAYLAND_DISPLAY") ? "wayland" : "";
    if (isSet("DISPLAY"))
        kinds += kinds.empty() ? "x11" : ",x11";
    return kinds;
}

std::unique_ptr<WindowDriver> openSdlWindow(std::string &problem) {
    const std::string kinds = screens();
    if (kinds.empty()) {
        problem = "neither DISPLAY nor WAYLAND_DISPLAY names a screen";
        return nullptr;
    }
    SDL_SetHint(SDL_HINT_VIDEODRIVER, kinds.c_str());
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1"); // Ctrl-C is the renderer's.
    SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0"); // It would take OpenGL to copy pixels.
    const bool begun = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
    SDL_Window *const window =
        begun ? SDL_CreateWindow("candela", SDL_WINDOWPOS_UNDEFINED, SDL_WINDOWPOS_UNDEFINED, 64,
                                 64, SDL_WINDOW_RESIZABLE | SDL_WINDOW_HIDDEN)
              : nullptr;
    if (window)
        return std::make_unique<SdlWindow>(window);
    problem = SDL_GetError();
    if (begun)
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    return nullptr;
}

} // namespace

} // namespace candela

extern "C" candela::WindowOpener candelaWindowOpener(int version);

candela::WindowOpener candelaWindowOpener(int version) {
    return version == candela::windowOpenerVersion ? &candela::openSdlWindow : nullptr;
}
