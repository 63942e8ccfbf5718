// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/cone_lobes.h"

#include "language/ir/analyse/dependence.h"
#include "language/ir/core/regions.h"

#include "foundation/units/color.h"

#include <algorithm>

namespace candela::ir {

namespace {

using Product = std::vector<ValueId>;
constexpr std::size_t mostProducts = 16, mostLobes = 4, mostFactors = 64;
constexpr int mostVisits = 1 << 12; ///< Of values, which may be part of many products.

/// A lobe's shape: all of Cone but what belongs to its request.
struct Cosine {
    Triple axis{};
    std::optional<Triple> mirrored;
    bool ofUnit = false; ///< Of L itself or of the vector of unit length.
};

class LobeReader {
public:
    LobeReader(const Function &text, const Dependence &dependence, const Instruction &loop)
        : text_(text), dependence_(dependence), loop_(loop), body_(loop.regions[0]) {}

    std::vector<Cone> run(const Cone &whole) {
        std::vector<Cone> cones;
        for (const Cone::Weight &weight : whole.weights) {
            ValueId carried = argumentOf(loop_, std::size_t(weight.result));
            std::vector<Product> products = expand(body_.yields[weight.result]);
            if (products.size() > mostProducts)
                return {};
            for (const Product &product : products)
                if (product != Product{carried} && !add(whole, weight.result, product, cones))
                    return {};
        }
        for (Cone &cone : cones)
            cone.exact &= !divides_;
        return cones.size() > mostLobes ? std::vector<Cone>{} : cones;
    }

private:
    const Instruction *definition(ValueId v) const { return dependence_.definition[v].instruction; }
    bool early(ValueId v) const { return dependence_.bindingTime[v] < BindingTime::Response; }
    bool early(const Triple &t) const { return early(t[0]) && early(t[1]) && early(t[2]); }

    static std::vector<Product> times(const std::vector<Product> &a,
                                      const std::vector<Product> &b) {
        std::vector<Product> result;
        for (const Product &x : a)
            for (const Product &y : b) {
                if (x.size() + y.size() > mostFactors)
                    return std::vector<Product>(mostProducts + 1);
                result.push_back(x);
                result.back().insert(result.back().end(), y.begin(), y.end());
            }
        return result;
    }

    /// The value as a sum of products of factors that are no sums or products themselves; more than
    /// mostProducts, of whatever, if there are too many.
    std::vector<Product> expand(ValueId v) const {
        const Instruction *i = definition(v);
        if (early(v) || !i || cosine(v))
            return {{v}};
        if (++visits_ > mostVisits)
            return std::vector<Product>(mostProducts + 1);
        std::vector<Product> sum;
        auto collect = [&](ValueId part) {
            if (sum.size() > mostProducts)
                return;
            auto more = expand(part);
            sum.insert(sum.end(), more.begin(), more.end());
        };
        switch (i->op) {
        case Op::Mul: {
            auto left = expand(i->operands[0]), right = expand(i->operands[1]);
            if (left.size() * right.size() > mostProducts)
                return std::vector<Product>(mostProducts + 1);
            return times(left, right);
        }
        case Op::Div: // By a length, as a rule: no factor that shapes the lobe.
            divides_ |= !early(i->operands[1]);
            return expand(i->operands[0]);
        case Op::Add:
            collect(i->operands[0]);
            collect(i->operands[1]);
            return sum;
        case Op::Select:
            collect(i->operands[1]);
            collect(i->operands[2]);
            return sum;
        case Op::If: // Values under an earlier condition could not be written outside of it.
            if (early(i->operands[0]))
                return {{v}};
            for (const Region &region : i->regions)
                collect(region.yields[dependence_.definition[v].result]);
            return sum;
        default: return {{v}};
        }
    }

    /// Adds the product to the lobe that it belongs to; false if it has no Cl at all.
    bool add(const Cone &whole, int result, const Product &product, std::vector<Cone> &cones) {
        Cone lobe = whole;
        lobe.weights.clear();
        Cone::Weight weight{result, {}};
        bool lit = false;
        int others = 0;
        for (ValueId factor : product) {
            if (early(factor))
                weight.factors.push_back(factor);
            else if (isCl(factor))
                lit = true;
            else
                shape(factor, lobe), others += isNeverNegative(factor) ? 1 : 2;
        }
        lobe.exact = others == 1 && lobe.kind == Cone::Kind::Lobe && !lobe.mirrored;
        if (!lit) // A sum of zeros, or something that light only chooses.
            return product.size() == 1 && early(product[0]);
        auto same = std::find_if(cones.begin(), cones.end(), [&](const Cone &known) {
            return known.kind == lobe.kind && known.axis == lobe.axis &&
                   known.mirrored == lobe.mirrored && known.exponent == lobe.exponent;
        });
        if (same == cones.end())
            same = cones.insert(same, lobe);
        same->weights.push_back(weight);
        same->exact &= lobe.exact;
        return true;
    }

    const float *number(ValueId v) const {
        const Instruction *i = definition(v);
        return i && i->op == Op::ConstFloat ? &i->number : nullptr;
    }

    /// A cosine with the direction of light, or a power of one, below 0 nowhere in the loop: it is
    /// clamped, or the loop leaves out all light behind its axis.
    bool isNeverNegative(ValueId factor) const {
        const Instruction *i = definition(factor);
        if (i && i->op == Op::Pow && early(i->operands[1]))
            return isNeverNegative(i->operands[0]);
        const auto found = cosine(factor);
        if (!found || !found->ofUnit)
            return false;
        if (i->op == Op::Max)
            for (int k : {0, 1})
                if (const float *least = number(i->operands[k]); least && *least == 0)
                    return true;
        constexpr float quarterTurn = 1.5707964f;
        const float *angle = loop_.operands.size() > 6 ? number(loop_.operands[6]) : nullptr;
        return text_.requests[loop_.immediate].form == ConeForm::Classic && angle &&
               *angle <= quarterTurn && isAlongLoopAxis(found->axis);
    }

    /// The loop's axis itself, or what it is normalised from.
    bool isAlongLoopAxis(const Triple &axis) const {
        const ValueId *ofLoop = loop_.operands.data() + 3;
        const auto isScaled = [&](int k) {
            const Instruction *i = definition(ofLoop[k]);
            return i && i->op == Op::Mul && i->operands[0] == axis[k] &&
                   isReciprocalLength(i->operands[1]);
        };
        return std::equal(axis.begin(), axis.end(), ofLoop) ||
               (isScaled(0) && isScaled(1) && isScaled(2));
    }

    /// 1 / length, or 1 / (1 where that is 0).
    bool isReciprocalLength(ValueId v) const {
        const Instruction *i = definition(v);
        const float *one = i && i->op == Op::Div ? number(i->operands[0]) : nullptr;
        const Instruction *length = one && *one == 1 ? definition(i->operands[1]) : nullptr;
        if (length && length->op == Op::Select)
            length = definition(length->operands[2]);
        return length && length->op == Op::Sqrt;
    }

    bool isCl(ValueId v) const {
        auto first = body_.arguments.begin() + 3;
        return std::find(first, first + text_.colors.samples, v) != first + text_.colors.samples;
    }

    /// A power shapes the lobe more than a plain cosine does.
    void shape(ValueId factor, Cone &lobe) const {
        const Instruction *i = definition(factor);
        bool power = i && i->op == Op::Pow && early(i->operands[1]);
        auto found = cosine(power ? i->operands[0] : factor);
        if (!found || (lobe.kind == Cone::Kind::Lobe && !power))
            return;
        lobe.kind = Cone::Kind::Lobe;
        lobe.axis = found->axis;
        lobe.mirrored = found->mirrored;
        lobe.exponent = power ? std::optional(i->operands[1]) : std::nullopt;
        lobe.exponentScale = found->mirrored ? 0.25f : 1.0f;
    }

    /// A.L or A.H, perhaps clamped.
    std::optional<Cosine> cosine(ValueId v) const {
        const Instruction *i = definition(v);
        if (i && (i->op == Op::Max || i->op == Op::Min))
            for (int k : {0, 1})
                if (early(i->operands[k]))
                    return cosine(i->operands[1 - k]);
        if (!i || i->op != Op::Add)
            return {};
        const Instruction *sum = definition(i->operands[0]);
        if (!sum || sum->op != Op::Add)
            return {};
        const Instruction *product[3] = {definition(sum->operands[0]), definition(sum->operands[1]),
                                         definition(i->operands[1])};
        for (const Instruction *p : product)
            if (!p || p->op != Op::Mul)
                return {};
        for (int side : {0, 1}) {
            Triple axis, light;
            for (int c = 0; c < 3; ++c) {
                axis[c] = product[c]->operands[side];
                light[c] = product[c]->operands[1 - side];
            }
            if (!early(axis))
                continue;
            if (isLight(light))
                return Cosine{axis, {}, isUnitLight(light)};
            if (auto view = halfVector(light))
                return Cosine{axis, view, false};
        }
        return {};
    }

    /// The vector that was scaled to this one, or itself.
    Triple unscaled(const Triple &t) const {
        const Instruction *i[3] = {definition(t[0]), definition(t[1]), definition(t[2])};
        for (const Instruction *c : i)
            if (!c || c->op != i[0]->op || (c->op != Op::Mul && c->op != Op::Div))
                return t;
        for (int scale : {1, 0})
            if (i[0]->operands[scale] == i[1]->operands[scale] &&
                i[0]->operands[scale] == i[2]->operands[scale] &&
                (scale == 1 || i[0]->op == Op::Mul))
                return {i[0]->operands[1 - scale], i[1]->operands[1 - scale],
                        i[2]->operands[1 - scale]};
        return t;
    }

    bool isLight(const Triple &t) const {
        Triple plain = unscaled(t);
        return std::equal(plain.begin(), plain.end(), body_.arguments.begin());
    }

    /// L, or L over its length.
    bool isUnitLight(const Triple &t) const {
        if (std::equal(t.begin(), t.end(), body_.arguments.begin()))
            return true;
        const Instruction *i = definition(t[0]);
        return isLight(t) && i->op == Op::Mul &&
               (isReciprocalLength(i->operands[0]) || isReciprocalLength(i->operands[1]));
    }

    /// V, if the vector is L + V, perhaps scaled.
    std::optional<Triple> halfVector(const Triple &t) const {
        Triple plain = unscaled(t), view;
        const Instruction *i[3];
        for (int c = 0; c < 3; ++c) {
            i[c] = definition(plain[c]);
            if (!i[c] || (i[c]->op != Op::Add && i[c]->op != Op::Sub))
                return {};
        }
        for (int side : {0, 1}) {
            Triple light;
            for (int c = 0; c < 3; ++c) {
                light[c] = i[c]->operands[side];
                view[c] = i[c]->operands[1 - side];
            }
            if (i[0]->op == Op::Add && early(view) && isLight(light))
                return view;
        }
        return {};
    }

    const Function &text_;
    const Dependence &dependence_;
    const Instruction &loop_;
    const Region &body_;
    mutable int visits_ = 0;
    mutable bool divides_ = false; ///< Something is divided by what depends on the direction.
};

} // namespace

std::vector<Cone> recognizeLobes(const Function &text, const Dependence &dependence,
                                 const Instruction &loop, const Cone &whole) {
    return LobeReader(text, dependence, loop).run(whole);
}

} // namespace candela::ir
