// SPDX-License-Identifier: Apache-2.0
// A line sweeps from left to right. The segments that it is on are kept in their order along it, in
// which the first two that meet are neighbours before they do.
#include "world/geometry/simple_loops.h"

#include <algorithm>
#include <set>
#include <vector>

namespace candela {

namespace {

bool isBefore(FlatPoint a, FlatPoint b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Both from left to right.
bool meet(const FlatSegment &s, const FlatSegment &t) {
    return segmentsMeet(s.from, s.to, t.from, t.to);
}

/// From below to above, where both are on the sweeping line.
struct Below {
    bool operator()(const FlatSegment *s, const FlatSegment *t) const {
        return isBefore(t->from, s->from) ? side(*t, *s) < 0 : side(*s, *t) > 0;
    }
    /// On which side of a segment one lies that begins later.
    static double side(const FlatSegment &s, const FlatSegment &later) {
        const double begin = turn(s.from, s.to, later.from);
        return begin != 0 ? begin : turn(s.from, s.to, later.to);
    }
};

} // namespace

bool meetWithin(std::span<const FlatSegment> given) {
    std::vector<FlatSegment> segments;
    for (const FlatSegment &s : given)
        segments.push_back(isBefore(s.from, s.to) ? s : FlatSegment{s.to, s.from});
    std::vector<const FlatSegment *> starts, ends;
    for (const FlatSegment &s : segments)
        starts.push_back(&s), ends.push_back(&s);
    std::ranges::sort(starts, isBefore, [](const FlatSegment *s) { return s->from; });
    std::ranges::sort(ends, isBefore, [](const FlatSegment *s) { return s->to; });
    std::set<const FlatSegment *, Below> line;
    using Place = std::set<const FlatSegment *, Below>::iterator;
    std::vector<Place> places(segments.size());
    const auto placeOf = [&](const FlatSegment *s) -> Place & {
        return places[std::size_t(s - segments.data())];
    };
    const auto leave = [&](const FlatSegment *s) {
        const Place gone = placeOf(s), after = std::next(gone);
        const bool neighboursMeet =
            gone != line.begin() && after != line.end() && meet(**std::prev(gone), **after);
        line.erase(gone);
        return neighboursMeet;
    };
    auto end = ends.begin();
    for (const FlatSegment *next : starts) {
        for (; !isBefore(next->from, (*end)->to); ++end)
            if (leave(*end))
                return true;
        const auto [place, isNew] = line.insert(next);
        if (!isNew)
            return true; // One lies along the other.
        placeOf(next) = place;
        if ((place != line.begin() && meet(**std::prev(place), *next)) ||
            (std::next(place) != line.end() && meet(*next, **std::next(place))))
            return true;
    }
    return std::any_of(end, ends.end(), leave);
}

} // namespace candela
