// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/primitive_record.h"

namespace candela {

namespace {

float mix(float a, float b, double share) { return float(a + share * (double(b) - a)); }
Vec3 mix(Vec3 a, Vec3 b, double share) {
    return {mix(a.x, b.x, share), mix(a.y, b.y, share), mix(a.z, b.z, share)};
}

/// The numbers of a quadric or a blobby, in place.
struct Mix {
    double share;

    void operator()(SphereRecord &a, const SphereRecord &b) const {
        each(a, b, &SphereRecord::radius, &SphereRecord::zMin, &SphereRecord::zMax,
             &SphereRecord::thetaMax);
    }
    void operator()(ConeRecord &a, const ConeRecord &b) const {
        each(a, b, &ConeRecord::height, &ConeRecord::radius, &ConeRecord::thetaMax);
    }
    void operator()(CylinderRecord &a, const CylinderRecord &b) const {
        each(a, b, &CylinderRecord::radius, &CylinderRecord::zMin, &CylinderRecord::zMax,
             &CylinderRecord::thetaMax);
    }
    void operator()(HyperboloidRecord &a, const HyperboloidRecord &b) const {
        each(a, b, &HyperboloidRecord::thetaMax);
        each(a, b, &HyperboloidRecord::point1, &HyperboloidRecord::point2);
    }
    void operator()(ParaboloidRecord &a, const ParaboloidRecord &b) const {
        each(a, b, &ParaboloidRecord::rMax, &ParaboloidRecord::zMin, &ParaboloidRecord::zMax,
             &ParaboloidRecord::thetaMax);
    }
    void operator()(DiskRecord &a, const DiskRecord &b) const {
        each(a, b, &DiskRecord::height, &DiskRecord::radius, &DiskRecord::thetaMax);
    }
    void operator()(TorusRecord &a, const TorusRecord &b) const {
        each(a, b, &TorusRecord::majorRadius, &TorusRecord::minorRadius, &TorusRecord::phiMin,
             &TorusRecord::phiMax, &TorusRecord::thetaMax);
    }
    void operator()(BlobbyRecord &a, const BlobbyRecord &b) const {
        for (std::size_t k = 0; k < a.floats.size(); ++k)
            a.floats[k] = mix(a.floats[k], b.floats[k], share);
    }
    /// Others are all in their variables.
    template <class A, class B> void operator()(A &, const B &) const {}

private:
    template <class Record, class... Member>
    void each(Record &a, const Record &b, Member... member) const {
        ((a.*member = mix(a.*member, b.*member, share)), ...);
    }
};

/// What is the same of shapes whatever they do.
struct SameCounts {
    bool operator()(const PolygonsRecord &a, const PolygonsRecord &b) const {
        return a.loopCounts == b.loopCounts && a.vertexCounts == b.vertexCounts &&
               a.vertices == b.vertices;
    }
    bool operator()(const PatchMeshRecord &a, const PatchMeshRecord &b) const {
        return a.bicubic == b.bicubic && a.uVertices == b.uVertices && a.vVertices == b.vVertices &&
               a.uPeriodic == b.uPeriodic && a.vPeriodic == b.vPeriodic;
    }
    bool operator()(const NuPatchRecord &a, const NuPatchRecord &b) const {
        return isSame(a.u, b.u) && isSame(a.v, b.v);
    }
    bool operator()(const SubdivisionRecord &a, const SubdivisionRecord &b) const {
        return a.scheme == b.scheme && a.vertexCounts == b.vertexCounts &&
               a.vertices == b.vertices && a.holes == b.holes;
    }
    bool operator()(const GeometryRecord &a, const GeometryRecord &b) const {
        return a.type == b.type;
    }
    bool operator()(const CurvesRecord &a, const CurvesRecord &b) const {
        return a.cubic == b.cubic && a.periodic == b.periodic && a.vertexCounts == b.vertexCounts;
    }
    bool operator()(const BlobbyRecord &a, const BlobbyRecord &b) const {
        return a.leaves == b.leaves && a.codes == b.codes && a.strings == b.strings &&
               a.floats.size() == b.floats.size();
    }
    template <class Record> bool operator()(const Record &, const Record &) const { return true; }
    template <class A, class B> bool operator()(const A &, const B &) const { return false; }

private:
    static bool isSame(const SplineRecord &a, const SplineRecord &b) {
        return a.order == b.order && a.knots == b.knots && a.low == b.low && a.high == b.high;
    }
};

} // namespace

std::shared_ptr<const PrimitiveRecord>
recordAt(const std::shared_ptr<const PrimitiveRecord> &record, double time) {
    if (!record->motion)
        return record;
    const auto &knots = record->motion->values;
    const KnotPlace place = placeAmong(record->motion->times, time);
    if (place.share == 0)
        return knots[place.knot];
    auto between = std::make_shared<PrimitiveRecord>(*knots[place.knot]);
    const PrimitiveRecord &next = *knots[place.next];
    std::visit(Mix{place.share}, between->shape, next.shape);
    between->variables = candela::between(between->variables, next.variables, place.share);
    return between;
}

bool canBecome(const PrimitiveRecord &a, const PrimitiveRecord &b) {
    if (!std::visit(SameCounts{}, a.shape, b.shape))
        return false;
    for (const Parameter &variable : a.variables.all) {
        const Parameter *other = b.variables.find(variable.name);
        if (!other || !(other->declaration == variable.declaration) ||
            other->floats.size() != variable.floats.size())
            return false;
    }
    return true;
}

} // namespace candela
