// SPDX-License-Identifier: Apache-2.0
// Packets of 16 rays, traced in packets of the width that Embree's kernels have: where it has none
// for 16 it would take the rays one by one.
#pragma once

#include <embree3/rtcore.h>

namespace candela {

/// 16, 8 or 4
int nativeWidth(RTCDevice);

/// As rtcIntersect16 and rtcOccluded16.
void intersectPackets(int width, const int *valid, RTCScene, RTCIntersectContext &, RTCRayHit16 &);
void occludedPackets(int width, const int *valid, RTCScene, RTCIntersectContext &, RTCRay16 &);

} // namespace candela
