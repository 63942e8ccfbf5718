// SPDX-License-Identifier: Apache-2.0
// How far a frame is, piece of work by piece of work, for those who would stop it, save it or take
// it up again.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <shared_mutex>
#include <vector>

namespace candela {

/// A place between two pieces of a frame's work. With what the sink has got up to there it is all
/// that a render needs to go on.
struct FramePosition {
    int firstSample = 0;                  ///< Of the pass under way, where passes begin.
    bool hasLightPaths = false;           ///< The light that its light paths bring has come.
    std::vector<std::uint8_t> tilesTaken; ///< 1 for each of its tiles whose samples have come.
    /// How many samples the halves of pixels shall have, where they may differ
    /// (frame/adaptive_sampling.h).
    std::vector<std::int32_t> wishes{};
};

/// Integrators bring their samples through it; others may look, stop or close it at any time.
class FrameProgress {
public:
    FrameProgress() = default;
    /// Goes on from there.
    explicit FrameProgress(FramePosition from) : position_(std::move(from)) {}

    /// No piece of work is begun any more; those that are under way still come.
    void stop() { stopped_ = true; }
    bool isStopped() const { return stopped_; }
    /// Nothing comes any more, whoever still works.
    void close();
    /// Calls look(position) while nothing comes, so that samples and position belong together; look
    /// gets null amid the light paths of a pass, which belong to no position.
    template <class Look> void hold(const Look &look) {
        std::unique_lock lock(mutex_);
        look(lightPathsComing_ ? nullptr : &position_);
    }

    int firstSample() const { return position_.firstSample; }
    /// Before the work of each pass, by the integrator alone. Of the pass that is gone on with,
    /// what has come stays as it is.
    void beginPass(int firstSample, std::size_t tiles);
    bool hasLightPaths() const { return position_.hasLightPaths; }
    void beginLightPaths();
    void endLightPaths();
    /// Before the first pass, by the integrator alone; those that are there stay.
    void makeRoomForWishes(std::size_t count) { position_.wishes.resize(count); }
    /// Those of a tile are written where its samples are brought.
    std::vector<std::int32_t> &wishes() { return position_.wishes; }
    bool isTaken(std::size_t tile) const { return position_.tilesTaken[tile] != 0; }
    /// bring() hands a tile's samples on; from any thread.
    template <class Bring> void bringTile(std::size_t tile, const Bring &bring) {
        std::shared_lock lock(mutex_);
        if (isClosed_)
            return;
        bring();
        position_.tilesTaken[tile] = 1;
    }
    /// Likewise what belongs to no tile.
    template <class Bring> void bring(const Bring &bring) {
        std::shared_lock lock(mutex_);
        if (!isClosed_)
            bring();
    }

private:
    std::shared_mutex mutex_; ///< Shared by those who bring.
    FramePosition position_;
    bool lightPathsComing_ = false, isClosed_ = false;
    std::atomic<bool> stopped_{false};
};

} // namespace candela
