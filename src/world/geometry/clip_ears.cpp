// SPDX-License-Identifier: Apache-2.0
// A corner that is no ear waits for the corner that stands in it, and is looked at again when that
// one has gone.
#include "world/geometry/clip_ears.h"

#include "world/geometry/corner_tree.h"

#include <deque>

namespace candela {

namespace {

class EarClipper {
public:
    EarClipper(const FlatLoop &loop, std::vector<std::array<std::uint32_t, 3>> &triangles)
        : loop_(loop), triangles_(triangles), next_(loop.size()), previous_(loop.size()),
          turnToken_(loop.size()), isGone_(loop.size()), isTouching_(loop.size()),
          waiting_(loop.size()), notConvex_(loop), remaining_(int(loop.size())) {
        const int n = remaining_;
        for (int i = 0; i < n; ++i)
            next_[i] = (i + 1) % n, previous_[i] = (i + n - 1) % n;
        for (int i = 0; i < n; ++i) {
            notConvex_.set(i, !(bend(i) > 0));
            lookAtLater(i);
        }
    }

    bool run(WithoutEars otherwise) {
        bool isClean = true;
        int survivor = 0; // Some corner that is left.
        while (remaining_ >= 3) {
            int corner = nextToLookAt();
            if (corner < 0) {
                corner = mostConvex(survivor);
                if (!(bend(corner) > 0))
                    return isClean; // What is left has shrunk to a line.
                isClean = false;
                if (otherwise == WithoutEars::Stop)
                    return false;
            } else if (!isEar(corner)) {
                continue;
            }
            triangles_.push_back(
                {indexOf(previous_[corner]), indexOf(corner), indexOf(next_[corner])});
            survivor = next_[corner];
            remove(corner);
        }
        return isClean;
    }

private:
    /// A corner whose turn it is, as it was when this was noted.
    struct Turn {
        int corner;
        std::uint32_t token;
    };

    FlatPoint place(int i) const { return loop_[std::size_t(i)].place; }
    std::uint32_t indexOf(int i) const { return std::uint32_t(loop_[std::size_t(i)].index); }
    double bend(int i) const { return turn(place(previous_[i]), place(i), place(next_[i])); }

    void lookAtLater(int i) { queue_.push_back({i, ++turnToken_[i]}); }
    /// -1 if it is nobody's turn.
    int nextToLookAt() {
        while (!queue_.empty()) {
            const Turn turn = queue_.front();
            queue_.pop_front();
            if (!isGone_[turn.corner] && turnToken_[turn.corner] == turn.token)
                return turn.corner;
        }
        return -1;
    }

    /// Otherwise it waits for who stands in it.
    bool isEar(int tip) {
        if (notConvex_.has(tip))
            return false;
        if (remaining_ == 3)
            return true;
        const int a = previous_[tip], c = next_[tip];
        // The one that is likely to go last.
        const int blocker = notConvex_.farthest(place(a), place(tip), place(c), [&](int p) {
            return p != a && p != c && p != tip && blocks(p, a, tip, c);
        });
        if (blocker < 0)
            return true;
        waiting_[blocker].push_back(tip);
        const FlatPoint p = place(blocker);
        isTouching_[blocker] |= p == place(a) || p == place(tip) || p == place(c);
        return false;
    }

    /// Corners that stand where a corner of the ear does (bridges make them) block it only if
    /// their edges run into it.
    bool blocks(int p, int a, int tip, int c) const {
        const FlatPoint A = place(a), T = place(tip), C = place(c), q = place(p);
        const auto edgesEnter = [&](FlatPoint before, FlatPoint corner, FlatPoint after) {
            return pointsInside(before, corner, after, place(next_[p])) ||
                   pointsInside(before, corner, after, place(previous_[p]));
        };
        if (q == A)
            return edgesEnter(C, A, T);
        if (q == T)
            return edgesEnter(A, T, C);
        if (q == C)
            return edgesEnter(T, C, A);
        return true;
    }

    /// Of the corners around that one, if any is convex there.
    int mostConvex(int start) const {
        constexpr int around = 1000;
        int best = start, seen = 0;
        for (int i = next_[start]; i != start && (seen < around || !(bend(best) > 0));
             i = next_[i], ++seen)
            if (bend(i) > bend(best))
                best = i;
        return best;
    }

    /// Its neighbours' turn comes after all others', so that fans stay short.
    void remove(int corner) {
        const int a = previous_[corner], c = next_[corner];
        next_[a] = c, previous_[c] = a;
        isGone_[corner] = true;
        notConvex_.set(corner, false);
        --remaining_;
        release(corner);
        for (int i : {a, c}) {
            notConvex_.set(i, !(bend(i) > 0)); // It may also have closed, along collinear parts.
            lookAtLater(i);
            if (!notConvex_.has(i) || isTouching_[i])
                release(i);
        }
    }

    void release(int blocker) {
        std::vector<int> &waiting = waiting_[blocker];
        for (int tip : waiting)
            if (!isGone_[tip])
                lookAtLater(tip);
        waiting.clear();
    }

    const FlatLoop &loop_;
    std::vector<std::array<std::uint32_t, 3>> &triangles_;
    std::vector<int> next_, previous_;
    std::vector<std::uint32_t> turnToken_;
    std::vector<char> isGone_, isTouching_; ///< It blocks where it stands on an ear's own corner.
    std::vector<std::vector<int>> waiting_; ///< For each corner that blocks.
    CornerTree notConvex_;                  ///< Only such corners can lie in an ear.
    std::deque<Turn> queue_;
    int remaining_;
};

} // namespace

bool clipEars(const FlatLoop &loop, WithoutEars otherwise,
              std::vector<std::array<std::uint32_t, 3>> &triangles) {
    return EarClipper(loop, triangles).run(otherwise);
}

} // namespace candela
