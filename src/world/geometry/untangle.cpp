// SPDX-License-Identifier: Apache-2.0
// Sides are cut where they meet. Around each vertex of the graph that they make, sectors between
// sides are inside or outside; what is known of one sector tells of all that hang together. The
// sides between inside and outside make the loops of the faces.
#include "world/geometry/untangle.h"

#include "world/geometry/segment_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace candela {

namespace {

/// Of a place: whether the outside, and whether holes wind around it an odd number of times.
using Parity = unsigned;
constexpr Parity byOutside = 1, byHoles = 2, unknown = 4;

bool isInside(Parity parity) { return parity == byOutside; }

/// Looks at all sides, for each part of the graph and each hole.
constexpr double mostLooks = 2e9;

class Graph {
public:
    /// All places are within `extent` of 0.
    Graph(double extent, int firstMade, std::vector<MadeCorner> &made)
        : cell_(1e-10 * extent), firstMade_(firstMade), made_(made) {}

    void addLoop(const FlatLoop &loop, Parity kind) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const FlatVertex &from = loop[i], &to = loop[(i + 1) % loop.size()];
            if (from.place == to.place)
                continue;
            segments_.push_back({from.place, to.place});
            ends_.push_back({from.index, to.index});
            kinds_.push_back(kind);
            const std::size_t before = vertices_.size();
            vertexAt(from.place, from.index);
            crosses_ |= vertices_.size() == before;
        }
    }

    /// False if that is too much.
    bool cut() {
        std::vector<SegmentCut> cuts;
        if (!findCuts(segments_, cuts))
            return false;
        crosses_ |= !cuts.empty();
        std::ranges::sort(cuts, {}, [](const SegmentCut &c) {
            return std::tuple(c.segment, c.share, c.place.x, c.place.y);
        });
        std::map<std::pair<int, int>, Parity> kindsOf;
        auto cut = cuts.begin();
        for (int k = 0; k < int(segments_.size()); ++k) {
            int last = vertexAt(segments_[std::size_t(k)].from, 0);
            const auto goTo = [&](int vertex) {
                if (vertex != last)
                    kindsOf[std::minmax(last, vertex)] ^= kinds_[std::size_t(k)];
                last = vertex;
            };
            for (; cut != cuts.end() && cut->segment == k; ++cut)
                goTo(vertexOf(*cut));
            goTo(vertexAt(segments_[std::size_t(k)].to, 0));
        }
        around_.resize(vertices_.size());
        for (const auto &[edge, kind] : kindsOf)
            if (kind != 0)
                for (auto [from, to] :
                     {std::pair(edge.first, edge.second), std::pair(edge.second, edge.first)}) {
                    around_[std::size_t(from)].push_back(int(sides_.size()));
                    sides_.push_back({from, to, kind});
                }
        for (std::vector<int> &sides : around_)
            std::ranges::sort(sides, [&](int a, int b) { return comesBefore(a, b); });
        return true;
    }

    /// Finds what is on the left of all sides. False if it is not the same from everywhere.
    bool judge() {
        isJudged_.resize(vertices_.size());
        std::vector<int> order(vertices_.size());
        for (int v = 0; v < int(order.size()); ++v)
            order[std::size_t(v)] = v;
        std::ranges::sort(order, {}, [&](int v) { return std::pair(at(v).x, at(v).y); });
        double looks = 0;
        for (int first : order) {
            const std::vector<int> &sides = around_[std::size_t(first)];
            if (sides.empty() || sides_[std::size_t(sides[0])].left != unknown)
                continue;
            if ((looks += double(sides_.size())) > mostLooks || !judgeFrom(first))
                return false;
        }
        return true;
    }

    std::optional<UntangledFaces> faces() {
        UntangledFaces result;
        result.cross = crosses_;
        std::vector<Loop> holes;
        std::vector<int> faceOf(sides_.size(), -1), holeOf(sides_.size(), -1);
        for (int side = 0; side < int(sides_.size()); ++side) {
            if (!isBorder(side) || sides_[std::size_t(side)].isTaken)
                continue;
            Loop loop;
            if (!follow(side, loop))
                return std::nullopt;
            const double area = doubleArea(loop.corners);
            const int number = area > 0 ? int(result.faces.size()) : int(holes.size());
            for (int each : loop.sides)
                (area > 0 ? faceOf : holeOf)[std::size_t(each)] = number;
            if (area > 0)
                result.faces.push_back({std::move(loop.corners), {}});
            else
                holes.push_back(std::move(loop));
        }
        if (double(holes.size()) * double(sides_.size()) > mostLooks)
            return std::nullopt;
        putHoles(holes, faceOf, holeOf, result);
        return result;
    }

private:
    /// One way along a side; the other way is the next or the previous one in number.
    struct Side {
        int from, to;
        Parity kind;           ///< What changes across it.
        Parity left = unknown; ///< What lies on its left.
        bool isTaken = false;  ///< By a loop.
    };
    struct Loop {
        FlatLoop corners;
        std::vector<int> sides;
    };

    FlatPoint at(int vertex) const { return vertices_[std::size_t(vertex)].place; }
    static int twin(int side) { return side ^ 1; }

    /// The vertex of that place, or beside it by less than what rounding makes of one crossing.
    int vertexAt(FlatPoint place, int index) {
        const long column = std::lround(place.x / cell_), row = std::lround(place.y / cell_);
        for (long i = column - 1; i <= column + 1; ++i)
            for (long j = row - 1; j <= row + 1; ++j)
                if (const auto found = known_.find({i, j}); found != known_.end())
                    return found->second;
        known_[{column, row}] = int(vertices_.size());
        vertices_.push_back({place, index});
        return int(vertices_.size()) - 1;
    }
    int vertexOf(const SegmentCut &cut) {
        const std::size_t before = vertices_.size();
        const int vertex = vertexAt(cut.place, firstMade_ + int(made_.size()));
        if (vertices_.size() > before)
            made_.push_back({ends_[std::size_t(cut.segment)], cut.share});
        return vertex;
    }

    /// Counter-clockwise, from the direction of +x on.
    bool comesBefore(int a, int b) const {
        const auto isLower = [&](int side) {
            const Side &s = sides_[std::size_t(side)];
            const double x = at(s.to).x - at(s.from).x, y = at(s.to).y - at(s.from).y;
            return y < 0 || (y == 0 && x < 0);
        };
        const bool lowA = isLower(a), lowB = isLower(b);
        if (lowA != lowB)
            return lowB;
        const Side &s = sides_[std::size_t(a)], &t = sides_[std::size_t(b)];
        return turn(at(s.from), at(s.to), at(t.to)) > 0;
    }

    /// How often sides are met on the way from a place to the left; the nearest of those that
    /// `counts`.
    template <class Counts> Parity lookLeft(FlatPoint from, const Counts &counts, int &nearest) {
        Parity parity = 0;
        double best = -std::numeric_limits<double>::infinity();
        nearest = -1;
        for (int k = 0; k < int(sides_.size()); k += 2) {
            const Side &side = sides_[std::size_t(k)];
            const FlatPoint a = at(side.from), b = at(side.to);
            if ((a.y <= from.y) == (b.y <= from.y))
                continue;
            const double x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
            if (!(x < from.x))
                continue;
            parity ^= side.kind;
            if (x > best && counts(k))
                best = x, nearest = k;
        }
        return parity;
    }

    /// From the leftmost vertex of what hangs together.
    bool judgeFrom(int first) {
        int ignored = 0;
        const Parity outer = lookLeft(
            at(first), [](int) { return false; }, ignored);
        // Its sides go up or to the right: the outer sector lies behind the last one upwards.
        const std::vector<int> &sides = around_[std::size_t(first)];
        int last = sides.back();
        for (int side : sides)
            if (at(sides_[std::size_t(side)].to).y >= at(first).y)
                last = side;
        sides_[std::size_t(last)].left = outer;
        std::vector<int> waiting{last};
        while (!waiting.empty()) {
            const int side = waiting.back();
            waiting.pop_back();
            if (!judgeAround(side, waiting))
                return false;
        }
        return true;
    }

    /// From what is on the left of one side to all sides of its vertex, and on to their other ends.
    bool judgeAround(int known, std::vector<int> &waiting) {
        const int vertex = sides_[std::size_t(known)].from;
        if (isJudged_[std::size_t(vertex)])
            return true;
        isJudged_[std::size_t(vertex)] = true;
        const std::vector<int> &all = around_[std::size_t(vertex)];
        const std::size_t start = std::size_t(std::ranges::find(all, known) - all.begin());
        Parity sector = sides_[std::size_t(known)].left;
        for (std::size_t k = 1; k <= all.size(); ++k) {
            const int side = all[(start + k) % all.size()];
            Side &here = sides_[std::size_t(side)], &back = sides_[std::size_t(twin(side))];
            const Parity before = sector;
            sector ^= here.kind;
            if ((here.left != unknown && here.left != sector) ||
                (back.left != unknown && back.left != before))
                return false;
            here.left = sector;
            if (back.left == unknown) {
                back.left = before;
                waiting.push_back(twin(side));
            }
        }
        return true;
    }

    bool isBorder(int side) const {
        return isInside(sides_[std::size_t(side)].left) &&
               !isInside(sides_[std::size_t(twin(side))].left);
    }

    /// The loop that goes on from a side between inside and outside, with the inside on its left.
    /// False if it does not close.
    bool follow(int first, Loop &loop) {
        int side = first;
        do {
            Side &here = sides_[std::size_t(side)];
            if (here.isTaken)
                return false;
            here.isTaken = true;
            loop.sides.push_back(side);
            loop.corners.push_back(vertices_[std::size_t(here.from)]);
            const std::vector<int> &all = around_[std::size_t(here.to)];
            std::size_t k = std::size_t(std::ranges::find(all, twin(side)) - all.begin());
            for (std::size_t turned = 0; turned == 0 || !isBorder(side); ++turned) {
                if (turned == all.size())
                    return false;
                k = (k + all.size() - 1) % all.size(); // Clockwise.
                side = all[k];
            }
        } while (side != first);
        return true;
    }

    /// Holes lie in the face whose side is met first to the left of them, or whose hole's is.
    void putHoles(std::vector<Loop> &holes, const std::vector<int> &faceOf,
                  const std::vector<int> &holeOf, UntangledFaces &result) {
        const auto leftmost = [](const Loop &hole) {
            return std::ranges::min_element(hole.corners, {},
                                            [](const FlatVertex &corner) {
                                                return std::pair(corner.place.x, corner.place.y);
                                            })
                ->place;
        };
        std::vector<int> order(holes.size()), parent(holes.size(), -1);
        for (int k = 0; k < int(order.size()); ++k)
            order[std::size_t(k)] = k;
        std::ranges::sort(order, {}, [&](int k) {
            const FlatPoint p = leftmost(holes[std::size_t(k)]);
            return std::pair(p.x, p.y);
        });
        for (int k : order) {
            int nearest = -1;
            lookLeft(
                leftmost(holes[std::size_t(k)]),
                [&](int side) { return isBorder(side) || isBorder(twin(side)); }, nearest);
            if (nearest < 0)
                continue;
            const std::size_t side = std::size_t(isBorder(nearest) ? nearest : twin(nearest));
            parent[std::size_t(k)] =
                faceOf[side] >= 0 ? faceOf[side] : parent[std::size_t(holeOf[side])];
            if (parent[std::size_t(k)] >= 0)
                result.faces[std::size_t(parent[std::size_t(k)])].holes.push_back(
                    std::move(holes[std::size_t(k)].corners));
        }
    }

    std::vector<FlatVertex> vertices_;
    double cell_;                                ///< The width of the cells of known_.
    std::map<std::pair<long, long>, int> known_; ///< Vertices by their places.
    std::vector<FlatSegment> segments_;
    std::vector<std::array<int, 2>> ends_; ///< What the ends of segments stand for.
    std::vector<Parity> kinds_;
    std::vector<Side> sides_;
    std::vector<char> isJudged_;           ///< Vertices.
    std::vector<std::vector<int>> around_; ///< Sides that leave a vertex, counter-clockwise.
    int firstMade_;
    std::vector<MadeCorner> &made_;
    bool crosses_ = false;
};

} // namespace

std::optional<UntangledFaces> untangle(const FlatLoop &outside, std::span<const FlatLoop> holes,
                                       int firstMade, std::vector<MadeCorner> &made) {
    const std::size_t before = made.size();
    double extent = 0;
    for (const FlatVertex &corner : outside)
        extent = std::max({extent, std::fabs(corner.place.x), std::fabs(corner.place.y)});
    for (const FlatLoop &hole : holes)
        for (const FlatVertex &corner : hole)
            extent = std::max({extent, std::fabs(corner.place.x), std::fabs(corner.place.y)});
    if (!(extent > 0))
        return std::nullopt;
    Graph graph(extent, firstMade, made);
    graph.addLoop(outside, byOutside);
    for (const FlatLoop &hole : holes)
        graph.addLoop(hole, byHoles);
    std::optional<UntangledFaces> result;
    if (graph.cut() && graph.judge())
        result = graph.faces();
    if (!result)
        made.resize(before);
    return result;
}

} // namespace candela
