// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/conversion.h"

#include <algorithm>

namespace candela::sl {

bool TypeSet::hasGeometric() const {
    return has(BaseType::Point) || has(BaseType::Vector) || has(BaseType::Normal);
}

std::string TypeSet::text() const {
    std::string result;
    for (int i = 0; i < baseTypeCount; ++i)
        if (has(BaseType(i)))
            result += (result.empty() ? "" : " or ") + std::string(nameOf(BaseType(i)));
    return arrayLength ? result + "[" + std::to_string(arrayLength) + "]" : result;
}

int conversionCost(BaseType from, BaseType to) {
    if (from == to)
        return 0;
    if (isGeometric(from) && isGeometric(to))
        return 1;
    if (from == BaseType::Float && isTriple(to))
        return 4;
    if (from == BaseType::Float && to == BaseType::Matrix)
        return 5;
    return impossible;
}

int conversionCost(const TypeSet &from, BaseType to) {
    if (from.empty())
        return 0;
    int best = impossible;
    for (int i = 0; i < baseTypeCount; ++i)
        if (from.has(BaseType(i)))
            best = std::min(best, conversionCost(BaseType(i), to));
    return from.arrayLength ? impossible : best;
}

bool castable(BaseType from, BaseType to) {
    return conversionCost(from, to) < impossible || (isTriple(from) && isTriple(to));
}

const char *conversionHint(BaseType from, BaseType to) {
    if (isTriple(from) && isTriple(to))
        return "; a cast says that it is meant";
    if (isGeometric(from) && to == BaseType::Float)
        return "; did you mean length(), xcomp() or a dot product?";
    if (from == BaseType::Color && to == BaseType::Float)
        return "; comp() takes one component";
    return "";
}

// A little more than a promotion of one operand costs: in `color c = noise(x) + 0.5` colour noise
// wins, but operands that are floats anyway are not promoted before their time.
int contextCost(BaseType result, std::optional<BaseType> wanted) {
    if (!wanted || result == *wanted)
        return 0;
    int cost = conversionCost(result, *wanted);
    return cost >= impossible ? 50 : cost == 1 ? 1 : cost + 1;
}

} // namespace candela::sl
