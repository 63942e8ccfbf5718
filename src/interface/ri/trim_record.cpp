// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/trim_record.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace candela {

namespace {

/// Takes numbers from the front of a list.
template <class Number> class Supply {
public:
    explicit Supply(const std::vector<Number> &numbers) : rest_(numbers) {}
    bool has(std::size_t count) const { return count <= rest_.size(); }
    bool isEmpty() const { return rest_.empty(); }
    std::vector<Number> take(std::size_t count) {
        const auto first = rest_.first(count);
        rest_ = rest_.subspan(count);
        return {first.begin(), first.end()};
    }

private:
    std::span<const Number> rest_;
};

bool allFinite(const std::vector<float> &numbers) {
    return std::ranges::all_of(numbers, [](float x) { return std::isfinite(x); });
}

std::string defectOf(const TrimCurveRecord &curve) {
    const SplineRecord &s = curve.spline;
    if (!allFinite(s.knots) || !std::ranges::is_sorted(s.knots))
        return "expected knots in increasing order";
    if (!(std::max(s.low, s.knots[s.order - 1]) < std::min(s.high, s.knots[s.vertices])))
        return "nothing of a curve's knots is between its minimum and maximum";
    if (!allFinite(curve.u) || !allFinite(curve.v) ||
        !std::ranges::all_of(curve.w, [](float w) { return w > 0 && std::isfinite(w); }))
        return "expected finite numbers, and w above 0";
    return {};
}

} // namespace

std::optional<TrimRecord> readTrim(const TrimNumbers &numbers, std::string &why) {
    const auto fail = [&](const std::string &reason) {
        why = reason;
        return std::nullopt;
    };
    const std::size_t curves = numbers.orders.size();
    if (numbers.vertexCounts.size() != curves || numbers.minima.size() != curves ||
        numbers.maxima.size() != curves)
        return fail("expected as many orders, minima, maxima and counts of vertices");
    Supply knots(numbers.knots), u(numbers.u), v(numbers.v), w(numbers.w);
    TrimRecord loops;
    std::size_t next = 0;
    for (int count : numbers.curveCounts) {
        if (count < 1 || std::size_t(count) > curves - next)
            return fail("the loops have other numbers of curves than there are curves");
        loops.emplace_back();
        for (int k = 0; k < count; ++k, ++next) {
            const int vertices = numbers.vertexCounts[next], order = numbers.orders[next];
            if (order < 2 || order > mostSplineOrder || vertices < order || vertices > 1 << 20)
                return fail("expected orders from 2 to " + std::to_string(mostSplineOrder) +
                            " and at least as many vertices");
            const std::size_t n = std::size_t(vertices);
            if (!knots.has(n + std::size_t(order)) || !u.has(n) || !v.has(n) || !w.has(n))
                return fail("there are fewer knots or vertices than the curves need");
            loops.back().push_back({{vertices, order, knots.take(n + std::size_t(order)),
                                     numbers.minima[next], numbers.maxima[next]},
                                    u.take(n),
                                    v.take(n),
                                    w.take(n)});
            if (const std::string defect = defectOf(loops.back().back()); !defect.empty())
                return fail(defect);
        }
    }
    if (next != curves || !knots.isEmpty() || !u.isEmpty() || !v.isEmpty() || !w.isEmpty())
        return fail("there are more curves, knots or vertices than the loops have");
    return loops;
}

namespace {

/// Calls for each list with its name among the attributes.
template <class Numbers, class Call> void forEachList(Numbers &numbers, Call call) {
    call("trimcurve:curves", numbers.curveCounts);
    call("trimcurve:orders", numbers.orders);
    call("trimcurve:vertices", numbers.vertexCounts);
    call("trimcurve:knots", numbers.knots);
    call("trimcurve:minima", numbers.minima);
    call("trimcurve:maxima", numbers.maxima);
    call("trimcurve:u", numbers.u);
    call("trimcurve:v", numbers.v);
    call("trimcurve:w", numbers.w);
}

} // namespace

void keepTrim(const TrimNumbers &numbers, Attributes &attributes) {
    forEachList(numbers, [&](const char *name, const auto &list) {
        Parameter &kept = attributes.named[name];
        kept.name = name;
        kept.declaration = {StorageClass::Uniform, ValueType::Float, int(list.size())};
        kept.floats.assign(list.begin(), list.end());
    });
}

TrimRecord trimOf(const Attributes &attributes) {
    TrimNumbers numbers;
    forEachList(numbers, [&](const char *name, auto &list) {
        if (const Parameter *kept = attributes.named.find(name))
            for (float number : kept->floats)
                list.push_back(static_cast<std::decay_t<decltype(list[0])>>(number));
    });
    std::string why;
    return readTrim(numbers, why).value_or(TrimRecord{});
}

bool trimsInside(const Attributes &attributes) {
    return attributes.named.string("trimcurve:sense", "inside") == "outside";
}

} // namespace candela
