// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/fuse.h"

#include "language/ir/core/regions.h"

#include <utility>

namespace candela::ir {

namespace {

class Fusion {
public:
    explicit Fusion(Function &function) : function_(function), values_(function.values.size()) {
        read(function.body);
    }

    void run() {
        fuse(function_.body);
        function_.isFused = true;
    }

private:
    struct ValueFacts {
        int uses = 0;
        bool isProduct = false, isNegatedProduct = false;
        const Region *home = nullptr; ///< Of a product: where it has been written,
        std::size_t place = 0;        ///< and where there.
    };

    void read(const Region &region) {
        for (const Instruction &i : region.body) {
            for (ValueId v : i.operands)
                ++values_[v].uses;
            for (const Region &inner : i.regions)
                read(inner);
            if (i.op == Op::Mul)
                values_[i.results[0]].isProduct = true;
            if (i.op == Op::Neg)
                values_[i.results[0]].isNegatedProduct = values_[i.operands[0]].isProduct;
        }
        for (ValueId v : region.yields)
            ++values_[v].uses;
    }

    /// Writes the region's body anew; products that have gone into a sum are left out at the end.
    void fuse(Region &region) {
        for (Instruction &i : std::exchange(region.body, {})) {
            for (Region &inner : i.regions)
                fuse(inner);
            if (i.op == Op::Add || i.op == Op::Sub)
                fuseSum(i, region);
            if (i.op == Op::Mul) {
                values_[i.results[0]].home = &region;
                values_[i.results[0]].place = region.body.size();
            }
            region.body.push_back(std::move(i));
        }
        std::erase_if(region.body, [&](const Instruction &i) {
            return i.op == Op::Mul && values_[i.results[0]].uses == 0;
        });
    }

    bool isDifferenceOfProducts(const Instruction &i) const {
        const ValueFacts &a = values_[i.operands[0]], &b = values_[i.operands[1]];
        if (i.op == Op::Sub)
            return a.isProduct && b.isProduct;
        return (a.isProduct && b.isNegatedProduct) || (a.isNegatedProduct && b.isProduct);
    }

    void fuseSum(Instruction &i, Region &region) {
        if (isDifferenceOfProducts(i))
            return;
        for (const int k : {1, 0}) {
            ValueFacts &product = values_[i.operands[k]];
            if (product.home != &region || product.uses != 1)
                continue;
            product.uses = 0;
            const std::vector<ValueId> factors = region.body[product.place].operands;
            ValueId first = factors[0], other = i.operands[1 - k];
            if (i.op == Op::Sub)
                (k == 1 ? first : other) = negated(k == 1 ? first : other, i, region);
            i.op = Op::MulAdd;
            i.operands = {first, factors[1], other};
            return;
        }
    }

    ValueId negated(ValueId v, const Instruction &by, Region &region) {
        const ValueId result = ValueId(function_.values.size());
        function_.values.push_back(function_.values[v]);
        values_.push_back({.uses = 1});
        region.body.push_back({.op = Op::Neg,
                               .operands = {v},
                               .results = {result},
                               .regions = {},
                               .line = by.line,
                               .file = by.file});
        return result;
    }

    Function &function_;
    std::vector<ValueFacts> values_;
};

} // namespace

void fuseProducts(Function &function) { Fusion(function).run(); }

} // namespace candela::ir
