// SPDX-License-Identifier: Apache-2.0
// Which volume a segment of a ray lies in. Volumes of a scene are numbered from 1; 0 is none:
// clear.
//
// - Straight from the eye, and between surfaces, it is the Atmosphere of the surface at the end.
// - A ray that passes to the inside of a surface that has an Interior is in that, until it comes
// out
//   of it; bodies may stand in bodies. Inside and outside are those of the orientation. A surface
//   without an Interior changes nothing: sheets may be of any orientation.
// - A ray that leaves a surface that has an Exterior on the outside is in that until it meets
//   something.
#pragma once

#include <cstdint>

namespace candela {

/// The volumes of a surface.
struct SurfaceMedia {
    std::int32_t atmosphere = 0, exterior = 0;
    std::int32_t interior =
        0; ///< None of one-sided surfaces: rays do not meet them on the way out.
    std::int32_t lightSet = 0; ///< The lights that its volumes hear.
};

/// How many volumes a scene may have.
inline constexpr int mostMedia = 0xffff;

/// What a ray is in: the interiors of up to three bodies, and the exterior of the surface that it
/// left. Of more bodies the outermost are forgotten. Zero = air.
class MediaAround {
public:
    MediaAround() = default;
    MediaAround(std::uint32_t inner, std::uint32_t outer)
        : words_(std::uint64_t(outer) << 32 | inner) {}
    std::uint32_t inner() const { return std::uint32_t(words_); }
    std::uint32_t outer() const { return std::uint32_t(words_ >> 32); }

    /// The volume of the segment to a surface that is met from the inside or not.
    std::int32_t towards(const SurfaceMedia &end, bool fromInside) const {
        return fromInside && end.interior != 0 ? end.interior : towardsAir(end.atmosphere);
    }
    /// Of the segment to something that has only an atmosphere.
    std::int32_t towardsAir(std::int32_t atmosphere) const {
        return body(0) != 0 ? body(0) : exterior() != 0 ? exterior() : atmosphere;
    }
    /// Behind a surface that the ray came to from its inside or not, and leaves to it or not.
    MediaAround beyond(const SurfaceMedia &surface, bool fromInside, bool toInside) const;

    bool operator==(const MediaAround &) const = default;

private:
    static constexpr int bodies = 3, bits = 16;
    std::int32_t field(int k) const { return std::int32_t(words_ >> (bits * k) & 0xffff); }
    std::int32_t body(int k) const { return field(k); } ///< The innermost first.
    std::int32_t exterior() const { return field(bodies); }
    void set(int k, std::int32_t medium) {
        words_ &= ~(std::uint64_t(0xffff) << (bits * k));
        words_ |= std::uint64_t(medium) << (bits * k);
    }
    int depthOf(std::int32_t medium) const;
    void enter(std::int32_t medium);
    void leave(std::int32_t medium);

    std::uint64_t words_ = 0;
};

} // namespace candela
