// SPDX-License-Identifier: Apache-2.0
// From shapes, objects and instances to Embree's scenes. Only this room includes it.
#pragma once

#include "world/rays/ray_world.h"

#include <embree3/rtcore.h>

#include <functional>
#include <string>

namespace candela {

/// Ray masks: shadow rays look for opaque shapes first, and walk through the others afterwards;
/// all others have the bits of their kinds.
inline constexpr unsigned opaqueBit = 1, transparentBit = 2;
/// What looks for the bodies of solids has this bit alone, and so does everything.
inline constexpr unsigned bodyBit = 1u << 31;
inline constexpr unsigned maskOfKinds(std::uint8_t kinds) { return unsigned(kinds) << 2; }
inline constexpr std::uint8_t allKinds = ray_kind::camera | ray_kind::diffuse | ray_kind::specular;

/// What a call tells the filters of one-sided shapes.
struct RayContext {
    RTCIntersectContext embree; ///< The first member, so that filters find the rest.
    bool fromLights = false;    ///< RayBatch::fromLights.
    bool collects = false;      ///< All that a ray meets is wanted, from both sides.
};

/// The device, and the first thing that it has complained of.
class EmbreeDevice {
public:
    EmbreeDevice();
    ~EmbreeDevice();
    EmbreeDevice(const EmbreeDevice &) = delete;

    RTCDevice get() const { return device_; }
    const std::string &failure() const { return failure_; }
    /// It has failed in its midst (threads that could not be had), and ends the program where what
    /// it has begun is released.
    bool isStuck() const { return isStuck_; }
    /// How many rays a packet holds that this device traces as it is: 16, 8 or 4.
    int packetWidth() const;

private:
    static void takeError(void *device, RTCError, const char *text);

    RTCDevice device_;
    std::string failure_;
    bool isStuck_ = false;
};

struct RayTracerUnits {
    float length = 1;   ///< Places are multiplied by it: a power of two.
    bool moves = false; ///< For choiceOf().
};
/// Shape i becomes geometry i of sceneOf(i).
void attachShapes(const EmbreeDevice &, const RayObject &, const RayTracerUnits &,
                  const std::function<RTCScene(std::size_t)> &sceneOf);
/// What is in a scene may be asked for all that rays meet, RayContext::collects.
enum class OfBodies : bool { No, Yes };
/// An empty scene; committed by the caller.
RTCScene newScene(const EmbreeDevice &, OfBodies);
/// The bits that rays must carry to meet the shape.
unsigned maskOf(const RayShape &);
/// Adds a placement of a committed scene, whose shapes have one of the bits of `mask`.
void attachInstance(const EmbreeDevice &, RTCScene world, unsigned geometry, RTCScene object,
                    unsigned mask, const RayInstance &, float unit);
/// The bits that rays must carry to meet anything of the object.
unsigned maskOf(const RayObject &);

} // namespace candela
