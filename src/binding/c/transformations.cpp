// SPDX-License-Identifier: Apache-2.0
// Transformations (RI 3.2, 4.3).
#include "binding/c/calls.h"

using namespace candela;
using namespace candela::c;

// clang-format off
RI_PLAIN(Identity, (), identity(ri.at()))
RI_PLAIN(Transform, (RtMatrix matrix), transform(ri.at(), matrixOf(matrix)))
RI_PLAIN(ConcatTransform, (RtMatrix matrix), concatTransform(ri.at(), matrixOf(matrix)))
RI_PLAIN(Perspective, (RtFloat fieldOfView), perspective(ri.at(), fieldOfView))
RI_PLAIN(Translate, (RtFloat dx, RtFloat dy, RtFloat dz), translate(ri.at(), dx, dy, dz))
RI_PLAIN(Rotate, (RtFloat angle, RtFloat dx, RtFloat dy, RtFloat dz), rotate(ri.at(), angle, dx, dy, dz))
RI_PLAIN(Scale, (RtFloat sx, RtFloat sy, RtFloat sz), scale(ri.at(), sx, sy, sz))
RI_PLAIN(Skew, (RtFloat angle, RtFloat dx1, RtFloat dy1, RtFloat dz1, RtFloat dx2, RtFloat dy2, RtFloat dz2), skew(ri.at(), angle, dx1, dy1, dz1, dx2, dy2, dz2))
RI_PLAIN(CoordinateSystem, (RtToken name), coordinateSystem(ri.at(), text(name)))
RI_PLAIN(ScopedCoordinateSystem, (RtToken name), scopedCoordinateSystem(ri.at(), text(name)))
RI_PLAIN(CoordSysTransform, (RtToken name), coordSysTransform(ri.at(), text(name)))
// clang-format on

RtPoint *RiTransformPoints(RtToken fromSpace, RtToken toSpace, RtInt n, RtPoint points[]) {
    RtPoint *result = nullptr;
    perform("RiTransformPoints", [&](Context &ri) {
        const auto cameraFrom = [&](RtToken space) {
            const auto matrix = ri.sink().cameraFrom(text(space));
            if (!matrix)
                ri.error("no coordinate system '" + text(space) +
                         "' is known here: \"camera\" and \"world\" are in a world, and those "
                         "that RiCoordinateSystem has named; RIB that is written has none");
            return matrix;
        };
        const auto from = cameraFrom(fromSpace), to = cameraFrom(toSpace);
        const auto back = to ? inverse(*to) : std::nullopt;
        if (to && !back)
            ri.error("the coordinate system '" + text(toSpace) + "' is flat");
        if (!from || !back || !points)
            return;
        const Matrix4 toFrom = (*from * *back).rounded();
        for (RtInt i = 0; i < n; ++i) {
            const Vec3 p = transformPoint(toFrom, {points[i][0], points[i][1], points[i][2]});
            points[i][0] = p.x, points[i][1] = p.y, points[i][2] = p.z;
        }
        result = points;
    });
    return result;
}
