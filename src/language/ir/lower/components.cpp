// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/components.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

#include <algorithm>

namespace candela::ir {

int componentCount(sl::BaseType base, int samples) {
    switch (base) {
    case sl::BaseType::Void: return 0;
    case sl::BaseType::Float:
    case sl::BaseType::String: return 1;
    case sl::BaseType::Color: return samples;
    case sl::BaseType::Matrix: return 16;
    default: return 3;
    }
}

Triple tripleOf(const Components &c) { return {c[0], c[1], c[2]}; }

Matrix matrixOf(const Components &c) {
    Matrix result;
    std::copy_n(c.begin(), 16, result.begin());
    return result;
}

Components componentsOf(const Triple &t) { return {t.begin(), t.end()}; }
Components componentsOf(const Matrix &m) { return {m.begin(), m.end()}; }

Components zero(Builder &b, sl::BaseType base, int length) {
    const int count = componentCount(b, base) * std::max(1, length);
    return Components(count, base == sl::BaseType::String ? text(b, "") : number(b, 0));
}

ValueId component(Builder &b, const Components &value, ValueId index) {
    const int last = int(value.size()) - 1;
    if (const float *known = constantFloat(b, index))
        return value[*known >= 0 ? int(std::min(*known, float(last))) : 0];
    ValueId result = value[last];
    for (int i = last - 1; i >= 0; --i)
        result = select(b, less(b, index, number(b, float(i + 1))), value[i], result);
    return result;
}

Components replaceComponent(Builder &b, Components value, ValueId index, ValueId replacement) {
    const int last = int(value.size()) - 1;
    if (const float *known = constantFloat(b, index)) {
        value[*known >= 0 ? int(std::min(*known, float(last))) : 0] = replacement;
        return value;
    }
    for (int i = 0; i <= last; ++i) {
        const ValueId notBelow =
            i == 0 ? boolean(b, true) : lessEqual(b, number(b, float(i)), index);
        const ValueId notAbove =
            i == last ? boolean(b, true) : less(b, index, number(b, float(i + 1)));
        value[i] = select(b, both(b, notBelow, notAbove), replacement, value[i]);
    }
    return value;
}

} // namespace candela::ir
