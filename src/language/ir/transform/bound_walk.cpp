// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_walk.h"

#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/regions.h"

#include <limits>
#include <utility>

namespace candela::ir {

BoundWalk::BoundWalk(const Function &old, Builder &b)
    : old_(old), b_(b), variation_(boundVariation(old)), rules_(old, b),
      written_(old.values.size()) {
    for (std::size_t a = 0; a < old.arrays.size(); ++a) {
        const Array &array = old.arrays[a];
        const auto add = [&](Type type) {
            const int index = addArray(b, type, array.size);
            b.function().arrays[std::size_t(index)].loopDepth = array.loopDepth;
            return index;
        };
        Memory memory{add(array.type)};
        if (variation_.array[a] && array.type == Type::Float)
            for (int &part : memory.form)
                part = add(Type::Float);
        else if (variation_.array[a])
            memory.unsure = add(Type::Bool);
        memory_.push_back(memory);
    }
}

void BoundWalk::walk(const Region &region) {
    for (const Instruction &i : region.body) {
        if (b_.budget().exceeded())
            return;
        b_.setLine(i.line);
        b_.setFile(i.file);
        walk(i);
    }
}

void BoundWalk::walk(const Instruction &i) {
    switch (i.op) {
    case Op::Output: return;
    case Op::If: return walkIf(i);
    case Op::Loop: return walkLoop(i);
    case Op::LightLoop: return skipLightLoop(i);
    case Op::ArrayLoad: return walkLoad(i);
    case Op::ArrayStore: return walkStore(i);
    default: rules_.write(i, written_);
    }
}

/// Surfaces' are written out in a uniform field before; those of lights hear no light.
void BoundWalk::skipLightLoop(const Instruction &i) {
    for (std::size_t k = 0; k < i.results.size(); ++k)
        written_[i.results[k]] = written_[initialOf(i, k)];
}

/// The values and what stands beside them, with as many parts as those in `like` have.
Values BoundWalk::take(const std::vector<ValueId> &old, const std::vector<ValueId> &like) {
    Values result;
    for (std::size_t k = 0; k < old.size(); ++k) {
        const BoundedValue &v = written_[old[k]];
        result.push_back(v.middle);
        if (!variation_.value[like[k]])
            continue;
        if (b_.type(v.middle) != Type::Float) {
            result.push_back(unsureOf(b_, v));
            continue;
        }
        const Values parts = formOf(b_, v).inOrder();
        result.insert(result.end(), parts.begin(), parts.end());
    }
    return result;
}

std::vector<BoundedValue> BoundWalk::give(const std::vector<ValueId> &like, const ValueId *now) {
    std::vector<BoundedValue> result;
    for (ValueId old : like) {
        result.push_back({*now++});
        if (!variation_.value[old])
            continue;
        if (old_.values[old].type == Type::Float) {
            result.back().form = FormParts::of(now);
            now += FormParts::count;
        } else {
            result.back().unsure = *now++;
        }
    }
    return result;
}

ValueId BoundWalk::nothingOf(Type type) {
    switch (type) {
    case Type::Bool: return boolean(b_, false);
    case Type::Integer: return integer(b_, 0);
    case Type::String: return text(b_, "");
    default: return number(b_, 0);
    }
}

void BoundWalk::walkIf(const Instruction &i) {
    const BoundedValue condition = written_[i.operands[0]];
    const Way before = way_;
    // A side that runs where the middle, or another point, takes it.
    const auto side = [&](const Region &region, const BoundedValue &taken) {
        if (taken.unsure) {
            const auto also = [&](std::optional<ValueId> way, ValueId more) {
                return way ? both(b_, *way, more) : more;
            };
            const ValueId sure = both(b_, taken.middle, negate(b_, *taken.unsure));
            way_ = {also(before.middle, taken.middle), also(before.all, sure)};
        }
        walk(region);
        way_ = before;
        return take(region.yields, i.results);
    };
    const BoundedValue otherwise{negate(b_, condition.middle), {}, condition.unsure};
    if (!condition.unsure) {
        const Values now = ifElse(
            b_, condition.middle, [&] { return side(i.regions[0], condition); },
            [&] { return side(i.regions[1], otherwise); });
        const auto results = give(i.results, now.data());
        for (std::size_t k = 0; k < i.results.size(); ++k)
            written_[i.results[k]] = results[k];
        return;
    }
    const auto where = [&](const BoundedValue &taken, const Region &region) {
        Values nothing;
        for (ValueId result : i.results) {
            const Type type = old_.values[result].type;
            nothing.push_back(nothingOf(type));
            if (variation_.value[result] && type == Type::Float)
                nothing.insert(nothing.end(), FormParts::count, number(b_, 0));
            else if (variation_.value[result])
                nothing.push_back(boolean(b_, false));
        }
        const Values now = ifElse(
            b_, maybe(b_, taken), [&] { return side(region, taken); }, [&] { return nothing; });
        return give(i.results, now.data());
    };
    const auto then = where(condition, i.regions[0]), other = where(otherwise, i.regions[1]);
    for (std::size_t k = 0; k < i.results.size(); ++k)
        written_[i.results[k]] = choice(b_, condition, then[k], other[k]);
}

void BoundWalk::walkLoop(const Instruction &i) {
    const Region &region = i.regions[0];
    const ValueId goesOn = region.arguments[0];
    const bool mayPart = variation_.value[goesOn];
    Values initial = take(i.operands, region.arguments);
    if (mayPart)
        initial.push_back(boolean(b_, false)); // Whether they have parted.
    const auto parts = [&](const BoundedValue &condition, ValueId parted) {
        return either(b_, parted, unsureOf(b_, condition));
    };
    const Values now = loop(b_, initial, [&](const Values &arguments) {
        const auto carried = give(region.arguments, arguments.data());
        for (std::size_t k = 0; k < carried.size(); ++k)
            written_[region.arguments[k]] = carried[k];
        walk(region);
        Values yields = take(region.yields, region.arguments);
        if (mayPart)
            yields.push_back(parts(carried[0], arguments.back()));
        return yields;
    });
    auto results = give(region.arguments, now.data());
    if (mayPart) {
        const ValueId parted = parts(results[0], now.back());
        for (BoundedValue &v : results)
            if (v.form)
                v.form = select(b_, parted, unknownForm(b_), *v.form);
            else if (v.unsure)
                v.unsure = either(b_, *v.unsure, parted);
        if (anyInstruction(region, [](const Instruction &s) { return s.op == Op::ArrayStore; }))
            ifThen(b_, parted, [&] { loseAll(); });
    }
    for (std::size_t k = 0; k < i.results.size(); ++k)
        written_[i.results[k]] = results[k];
}

BoundedValue BoundWalk::elementAt(int array, ValueId index) {
    const Memory &memory = memory_[std::size_t(array)];
    BoundedValue v{arrayLoad(b_, memory.middle, index)};
    if (memory.unsure >= 0)
        v.unsure = arrayLoad(b_, memory.unsure, index);
    if (!variation_.array[std::size_t(array)] || memory.unsure >= 0)
        return v;
    Values parts;
    for (int part : memory.form)
        parts.push_back(arrayLoad(b_, part, index));
    v.form = FormParts::of(parts.data());
    return v;
}

/// Whichever element it is.
FormParts BoundWalk::anyElement(int array, ValueId middle) {
    const float endless = std::numeric_limits<float>::infinity();
    const ValueId count = number(b_, float(old_.arrays[std::size_t(array)].size));
    const Values range =
        loop(b_, {boolean(b_, true), number(b_, 0), number(b_, endless), number(b_, -endless)},
             [&](const Values &now) {
                 const BoundedValue v = elementAt(array, unary(b_, Op::IntegerFromFloat, now[1]));
                 const FormParts f = formOf(b_, v);
                 const ValueId next = add(b_, now[1], number(b_, 1));
                 return Values{less(b_, next, count), next, min(b_, now[2], f.least),
                               max(b_, now[3], f.greatest)};
             });
    // One that is no number makes it unknown.
    return callBound(b_, RuntimeFunction::bound_settle,
                     {{middle, rangeForm(b_, middle, range[2], range[3])}}, {number(b_, 0)});
}

void BoundWalk::walkLoad(const Instruction &i) {
    const BoundedValue index = written_[i.operands[0]];
    BoundedValue v = elementAt(i.immediate, index.middle);
    if (index.unsure && old_.values[i.results[0]].type == Type::Float) {
        Values parts = ifElse(
            b_, *index.unsure, [&] { return anyElement(i.immediate, v.middle).inOrder(); },
            [&] { return formOf(b_, v).inOrder(); });
        v.form = FormParts::of(parts.data());
    } else if (index.unsure) {
        v.unsure = either(b_, unsureOf(b_, v), *index.unsure);
    }
    written_[i.results[0]] = v;
}

/// Where not all points come here, or the middle does not, the element may be what it was.
void BoundWalk::walkStore(const Instruction &i) {
    const BoundedValue index = written_[i.operands[0]];
    BoundedValue v = written_[i.operands[1]];
    if (index.unsure)
        ifThen(b_, *index.unsure, [&] { loseAll(); });
    if (way_.middle) {
        const BoundedValue was = elementAt(i.immediate, index.middle);
        v = choice(b_, {*way_.middle, {}, negate(b_, *way_.all)}, v, was);
    }
    const Memory &memory = memory_[std::size_t(i.immediate)];
    arrayStore(b_, memory.middle, index.middle, v.middle);
    if (memory.unsure >= 0)
        arrayStore(b_, memory.unsure, index.middle, unsureOf(b_, v));
    if (!variation_.array[std::size_t(i.immediate)] || memory.unsure >= 0)
        return;
    const Values parts = formOf(b_, v).inOrder();
    for (std::size_t part = 0; part < parts.size(); ++part)
        arrayStore(b_, memory.form[part], index.middle, parts[part]);
}

void BoundWalk::loseAll() {
    if (lost_ < 0)
        lost_ = addArray(b_, Type::Bool, 1);
    arrayStore(b_, lost_, integer(b_, 0), boolean(b_, true));
}

ValueId BoundWalk::isLost() {
    return lost_ < 0 ? boolean(b_, false) : arrayLoad(b_, lost_, integer(b_, 0));
}

} // namespace candela::ir
