// SPDX-License-Identifier: Apache-2.0
#include "world/rays/native_packets.h"

#include <cstring>

namespace candela {

namespace {

/// Embree's packets are planes of a word a ray: `Part` has some rays of `whole`, from `first` on.
template <class Part, class Whole, class Trace>
void tracePart(int first, const int *valid, Whole &whole, Trace trace) {
    constexpr std::size_t planes = sizeof(Whole) / 16 / sizeof(float);
    constexpr std::size_t bytes = sizeof(Part) / planes, wholeBytes = sizeof(Whole) / planes;
    static_assert(planes * bytes == sizeof(Part) && planes * wholeBytes == sizeof(Whole));
    alignas(64) int validPart[bytes / sizeof(int)];
    std::memcpy(validPart, valid + first, bytes);
    alignas(64) Part part;
    char *to = reinterpret_cast<char *>(&part);
    char *from = reinterpret_cast<char *>(&whole) + std::size_t(first) * sizeof(float);
    for (std::size_t plane = 0; plane < planes; ++plane)
        std::memcpy(to + plane * bytes, from + plane * wholeBytes, bytes);
    trace(validPart, part);
    for (std::size_t plane = 0; plane < planes; ++plane)
        std::memcpy(from + plane * wholeBytes, to + plane * bytes, bytes);
}

} // namespace

int nativeWidth(RTCDevice device) {
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED))
        return 16;
    return rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) ? 8 : 4;
}

void intersectPackets(int width, const int *valid, RTCScene scene, RTCIntersectContext &context,
                      RTCRayHit16 &rays) {
    if (width == 16)
        return rtcIntersect16(valid, scene, &context, &rays);
    for (int first = 0; first < 16; first += width) {
        if (width == 8)
            tracePart<RTCRayHit8>(first, valid, rays, [&](const int *there, RTCRayHit8 &part) {
                rtcIntersect8(there, scene, &context, &part);
            });
        else
            tracePart<RTCRayHit4>(first, valid, rays, [&](const int *there, RTCRayHit4 &part) {
                rtcIntersect4(there, scene, &context, &part);
            });
    }
}

void occludedPackets(int width, const int *valid, RTCScene scene, RTCIntersectContext &context,
                     RTCRay16 &rays) {
    if (width == 16)
        return rtcOccluded16(valid, scene, &context, &rays);
    for (int first = 0; first < 16; first += width) {
        if (width == 8)
            tracePart<RTCRay8>(first, valid, rays, [&](const int *there, RTCRay8 &part) {
                rtcOccluded8(there, scene, &context, &part);
            });
        else
            tracePart<RTCRay4>(first, valid, rays, [&](const int *there, RTCRay4 &part) {
                rtcOccluded4(there, scene, &context, &part);
            });
    }
}

} // namespace candela
