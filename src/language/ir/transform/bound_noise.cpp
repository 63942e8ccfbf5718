// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_noise.h"

#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_sources.h"
#include "language/runtime/noise_bends.h"

namespace candela::ir {

namespace {

/// Cell noise where the box touches no more than two cells along each coordinate: what these hold.
class CellBound {
public:
    CellBound(Builder &b, RuntimeFunction function, const std::vector<BoundedValue> &inputs)
        : b_(b), function_(function), areFew_(boolean(b, true)) {
        for (const BoundedValue &x : inputs) {
            const FormParts f = formOf(b, x);
            const ValueId low = unary(b, Op::Floor, f.least);
            const ValueId high = unary(b, Op::Floor, f.greatest);
            ends_.push_back({low, high});
            areFew_ = both(b, areFew_, lessEqual(b, sub(b, high, low), number(b, 1)));
            if (x.varies())
                varying_.push_back(ends_.size() - 1);
        }
    }

    std::vector<FormParts> of(const Values &middles) {
        Values least = middles, greatest = middles;
        for (unsigned corner = 0; corner < 1u << varying_.size(); ++corner) {
            const Values there = callRuntime(b_, int(function_), cornerAt(corner));
            for (std::size_t n = 0; n < middles.size(); ++n) {
                least[n] = min(b_, least[n], there[n]);
                greatest[n] = max(b_, greatest[n], there[n]);
            }
        }
        std::vector<FormParts> result;
        for (std::size_t n = 0; n < middles.size(); ++n)
            result.push_back(select(b_, areFew_, rangeForm(b_, middles[n], least[n], greatest[n]),
                                    rangeForm(b_, middles[n], number(b_, 0), number(b_, 1))));
        return result;
    }

private:
    Values cornerAt(unsigned corner) const {
        Values place;
        for (const auto &[low, high] : ends_)
            place.push_back(low);
        for (std::size_t k = 0; k < varying_.size(); ++k)
            if (corner >> k & 1)
                place[varying_[k]] = ends_[varying_[k]].second;
        return place;
    }

    Builder &b_;
    RuntimeFunction function_;
    std::vector<std::pair<ValueId, ValueId>> ends_;
    std::vector<std::size_t> varying_; ///< Inputs that do.
    ValueId areFew_;
};

/// Gradient noise: by value and slope in the middle and what its second derivatives are at most; in
/// boxes of middle size again by the same at the middles of 4 x 4 parts of the box, whose second
/// order is a sixteenth.
class NoiseBound {
public:
    NoiseBound(Builder &b, RuntimeFunction withSlopes, const std::vector<BoundedValue> &inputs,
               int dimensions, const Values &middles)
        : b_(b), withSlopes_(withSlopes), dimensions_(std::size_t(dimensions)),
          bend_(runtime::noiseBends[dimensions - 1]), middles_(middles) {
        for (const BoundedValue &x : inputs)
            place_.push_back(x.middle);
        for (std::size_t k = 0; k < dimensions_; ++k) {
            forms_.push_back(formOf(b, inputs[k]));
            far_.push_back(farthest(b, inputs[k]));
            const FormParts &f = forms_.back();
            partFar_.push_back(
                add(b, mul(b, number(b, partSide), add(b, size(b, f.alongU), size(b, f.alongV))),
                    f.off));
        }
        slopes_ = callRuntime(b, int(withSlopes), place_);
    }

    std::vector<FormParts> forms() {
        const ValueId bent = bentBy(far_), bentInParts = bentBy(partFar_);
        std::vector<FormParts> plain;
        Values parts;
        for (std::size_t n = 0; n < middles_.size(); ++n) {
            plain.push_back(plainForm(n, bent));
            append(parts, plain.back().inOrder());
        }
        // Of small ones the plane is good enough, in large ones parts show no more.
        const ValueId isWorthIt =
            both(b_, less(b_, number(b_, 0x1p-12f), bent), less(b_, bentInParts, number(b_, 0.5f)));
        const Values better = ifElse(
            b_, isWorthIt, [&] { return inParts(plain, bentInParts); }, [&] { return parts; });
        std::vector<FormParts> result;
        for (std::size_t n = 0; n < middles_.size(); ++n)
            result.push_back(settle(b_, middles_[n],
                                    FormParts::of(better.data() + n * FormParts::count),
                                    number(b_, 8)));
        return result;
    }

private:
    static constexpr float partsAlong = 4, partSide = 1 / partsAlong;

    static void append(Values &list, const Values &more) {
        list.insert(list.end(), more.begin(), more.end());
    }
    /// What the second order is at most, so far off in each coordinate.
    ValueId bentBy(const Values &far) {
        ValueId twice = number(b_, 0), mixed = number(b_, 0);
        for (std::size_t i = 0; i < dimensions_; ++i) {
            twice = add(b_, twice, mul(b_, far[i], far[i]));
            for (std::size_t j = 0; j < i; ++j)
                mixed = add(b_, mixed, mul(b_, far[i], far[j]));
        }
        return add(b_, mul(b_, number(b_, bend_.twice / 2), twice),
                   mul(b_, number(b_, bend_.mixed), mixed));
    }
    /// Of component n, of what noise with slopes gives.
    const ValueId *slopesOf(const Values &all, std::size_t n) const {
        return all.data() + middles_.size() + n * dimensions_;
    }
    ValueId along(const ValueId *slopes, ValueId FormParts::*part) {
        ValueId total = number(b_, 0);
        for (std::size_t k = 0; k < dimensions_; ++k)
            total = add(b_, total, mul(b_, slopes[k], forms_[k].*part));
        return total;
    }
    ValueId offBy(const ValueId *slopes) {
        ValueId total = number(b_, 0);
        for (std::size_t k = 0; k < dimensions_; ++k)
            total = add(b_, total, mul(b_, size(b_, slopes[k]), forms_[k].off));
        return total;
    }

    FormParts plainForm(std::size_t n, ValueId bent) {
        const ValueId *slopes = slopesOf(slopes_, n);
        ValueId far = number(b_, 0);
        for (ValueId f : far_)
            far = add(b_, far, f);
        const ValueId climb = mul(b_, number(b_, bend_.slope), far);
        return {along(slopes, &FormParts::alongU), along(slopes, &FormParts::alongV),
                add(b_, offBy(slopes), bent), max(b_, number(b_, 0), sub(b_, middles_[n], climb)),
                min(b_, number(b_, 1), add(b_, middles_[n], climb))};
    }

    /// All parts of all components' forms.
    Values inParts(const std::vector<FormParts> &plain, ValueId bent) {
        const ValueId zero = number(b_, 0), one = number(b_, 1);
        Values carried{boolean(b_, true), zero};
        for (std::size_t n = 0; n < middles_.size(); ++n)
            append(carried, {zero, one, zero}); // Off, least, greatest.
        const Values end = loop(b_, carried, [&](const Values &now) {
            const ValueId row = unary(b_, Op::Floor, mul(b_, now[1], number(b_, partSide)));
            const ValueId column = sub(b_, now[1], mul(b_, row, number(b_, partsAlong)));
            const auto middleOf = [&](ValueId part) {
                return add(b_, mul(b_, part, number(b_, 2 * partSide)), number(b_, partSide - 1));
            };
            const ValueId atU = middleOf(column), atV = middleOf(row);
            const Values there = callRuntime(b_, int(withSlopes_), placeAt(atU, atV));
            const ValueId next = add(b_, now[1], one);
            Values yields{less(b_, next, number(b_, partsAlong * partsAlong)), next};
            for (std::size_t n = 0; n < middles_.size(); ++n)
                append(yields, grown(plain[n], n, there, atU, atV, bent, now.data() + 2 + 3 * n));
            return yields;
        });
        Values result;
        for (std::size_t n = 0; n < middles_.size(); ++n) {
            const ValueId *part = end.data() + 2 + 3 * n;
            append(result, {plain[n].alongU, plain[n].alongV, min(b_, part[0], plain[n].off),
                            max(b_, part[1], plain[n].least), min(b_, part[2], plain[n].greatest)});
        }
        return result;
    }

    Values placeAt(ValueId atU, ValueId atV) {
        Values place = place_;
        for (std::size_t k = 0; k < dimensions_; ++k)
            place[k] = add(b_, place[k],
                           add(b_, mul(b_, forms_[k].alongU, atU), mul(b_, forms_[k].alongV, atV)));
        return place;
    }

    /// What is known after a part more: off the plane, least, greatest.
    Values grown(const FormParts &plane, std::size_t n, const Values &there, ValueId atU,
                 ValueId atV, ValueId bent, const ValueId *now) {
        const ValueId *slopes = slopesOf(there, n);
        const ValueId u = along(slopes, &FormParts::alongU), v = along(slopes, &FormParts::alongV);
        const ValueId side = number(b_, partSide);
        const auto across = [&](ValueId p, ValueId q) {
            return mul(b_, side, add(b_, size(b_, p), size(b_, q)));
        };
        const ValueId loose = add(b_, offBy(slopes), bent);
        const ValueId expected =
            add(b_, middles_[n], add(b_, mul(b_, plane.alongU, atU), mul(b_, plane.alongV, atV)));
        const ValueId off = add(b_, add(b_, size(b_, sub(b_, there[n], expected)), loose),
                                across(sub(b_, u, plane.alongU), sub(b_, v, plane.alongV)));
        const ValueId around = add(b_, loose, across(u, v));
        return {max(b_, now[0], off), min(b_, now[1], sub(b_, there[n], around)),
                max(b_, now[2], add(b_, there[n], around))};
    }

    Builder &b_;
    RuntimeFunction withSlopes_;
    std::size_t dimensions_;
    runtime::NoiseBend bend_;
    Values middles_, place_, slopes_;
    std::vector<FormParts> forms_;
    Values far_, partFar_; ///< By coordinate, from the middle of the box, and of a part of it.
};

} // namespace

std::vector<FormParts> boundOfNoise(Builder &b, RuntimeFunction function,
                                    const std::vector<BoundedValue> &inputs,
                                    const Values &middles) {
    const int dimensions = runtime::coordinatesOf(function);
    const auto withSlopes = runtime::withSlopes(function);
    if (dimensions == 0 || !withSlopes)
        return CellBound(b, function, inputs).of(middles);
    std::vector<FormParts> result;
    for (std::size_t k = std::size_t(dimensions); k < inputs.size(); ++k)
        if (inputs[k].varies()) { // Its period jumps.
            for (ValueId middle : middles)
                result.push_back(rangeForm(b, middle, number(b, 0), number(b, 1)));
            return result;
        }
    return NoiseBound(b, *withSlopes, inputs, dimensions, middles).forms();
}

} // namespace candela::ir
