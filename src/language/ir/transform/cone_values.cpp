// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/cone_values.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/transform/value_mapping.h"

#include <iterator>
#include <numbers>

namespace candela::ir {

namespace {

void addConeTests(Builder &b, const Function &text, Region &region,
                  std::vector<ConeTest> &coneTests) {
    std::vector<Instruction> body;
    for (Instruction &i : region.body) {
        for (Region &inner : i.regions)
            addConeTests(b, text, inner, coneTests);
        if (i.op == Op::LightLoop && text.requests[i.immediate].form == ConeForm::Classic) {
            ConeTest &test = coneTests[i.immediate];
            test.known = true;
            test.axis = {i.operands[3], i.operands[4], i.operands[5]};
            Region before = b.region({}, [&] {
                test.cosine = unary(b, Op::Cos, i.operands[6]);
                return Values{};
            });
            std::move(before.body.begin(), before.body.end(), std::back_inserter(body));
        }
        body.push_back(std::move(i));
    }
    region.body = std::move(body);
}

} // namespace

std::vector<ConeTest> addConeTests(Function &text) {
    std::vector<ConeTest> coneTests(text.requests.size());
    Builder b(text);
    addConeTests(b, text, text.body, coneTests);
    b.finish();
    return coneTests;
}

StatedCone stateCone(ValueMapping &mapping, Builder &b, const Instruction &request,
                     const Cone &cone) {
    auto operand = [&](int k) { return mapping.value(0, request.operands[k]); };
    StatedCone stated;
    stated.exponent = number(b, 0);
    switch (cone.kind) {
    case Cone::Kind::Stated: {
        int first = 3 + 6 * cone.index;
        stated.axis = {operand(first), operand(first + 1), operand(first + 2)};
        stated.angle = operand(first + 3);
        stated.exponent = operand(first + 4);
        stated.importance = max(b, operand(first + 5), number(b, 0));
        break;
    }
    case Cone::Kind::Sphere:
        stated.axis = input3(b, ShaderInput::N);
        stated.angle = number(b, 360);
        break;
    case Cone::Kind::Classic: {
        stated.axis = mapping.triple(0, cone.axis);
        ValueId degrees = mul(b, operand(6), number(b, 360 / std::numbers::pi_v<float>));
        stated.angle = min(b, degrees, number(b, 360));
        break;
    }
    case Cone::Kind::Lobe: {
        stated.axis = mapping.triple(0, cone.axis);
        if (cone.mirrored) {
            Triple about = normalize(b, stated.axis), v = mapping.triple(0, *cone.mirrored);
            stated.axis = sub(b, scale(b, about, mul(b, number(b, 2), dot(b, about, v))), v);
        }
        stated.angle = number(b, 180);
        ValueId exponent = cone.exponent ? mapping.value(0, *cone.exponent) : number(b, 1);
        stated.exponent = mul(b, exponent, number(b, cone.exponentScale));
        break;
    }
    case Cone::Kind::Delta:
        stated.axis = {operand(3), operand(4), operand(5)};
        stated.angle = number(b, 0);
        break;
    }
    return stated;
}

} // namespace candela::ir
