// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_sources.h"

#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"

#include <limits>
#include <numbers>

namespace candela::ir {

namespace {

/// Where an input's derivatives stand, component for component, and how far it may be off them.
struct Row {
    ShaderInput first, last, byU, byV, rest;
};
constexpr ShaderInput none = ShaderInput::Count;

constexpr Row rows[] = {
    {ShaderInput::P, ShaderInput::PLast_, ShaderInput::dPdu, ShaderInput::dPdv, ShaderInput::PRest},
    {ShaderInput::I, ShaderInput::ILast_, ShaderInput::dIdu, ShaderInput::dIdv, ShaderInput::IRest},
    {ShaderInput::Ps, ShaderInput::PsLast_, none, none, none},
    {ShaderInput::Ns, ShaderInput::IsLast_, none, none, none},
    {ShaderInput::N, ShaderInput::NLast_, ShaderInput::dNdu, ShaderInput::dNdv, ShaderInput::NRest},
    {ShaderInput::Ng, ShaderInput::NgLast_, ShaderInput::dNgdu, ShaderInput::dNgdv,
     ShaderInput::NRest},
    {ShaderInput::s, ShaderInput::s, ShaderInput::dsdu, ShaderInput::dsdv, ShaderInput::stRest},
    {ShaderInput::t, ShaderInput::t, ShaderInput::dtdu, ShaderInput::dtdv, ShaderInput::stRest},
    {ShaderInput::Cs, ShaderInput::CsLast_, ShaderInput::dCsdu, ShaderInput::dCsdv,
     ShaderInput::CRest},
    {ShaderInput::Os, ShaderInput::OsLast_, ShaderInput::dOsdu, ShaderInput::dOsdv,
     ShaderInput::CRest},
    {ShaderInput::dPdu, ShaderInput::dPdvLast_, none, none, ShaderInput::dPRest},
    {ShaderInput::dNdu, ShaderInput::dNdvLast_, none, none, ShaderInput::dRest},
    {ShaderInput::dsdu, ShaderInput::dtdv, none, none, ShaderInput::dRest},
    {ShaderInput::dNgdu, ShaderInput::dNgdvLast_, none, none, ShaderInput::dRest},
    {ShaderInput::dCsdu, ShaderInput::dOsdvLast_, none, none, ShaderInput::dRest},
};

const Row *rowOf(int plane) {
    for (const Row &row : rows)
        if (plane >= int(row.first) && plane <= int(row.last))
            return &row;
    return nullptr;
}

bool isParameter(int plane) { return plane == int(ShaderInput::u) || plane == int(ShaderInput::v); }

/// From the middle of the box to its sides.
ValueId halfOf(Builder &b, ShaderInput extent) { return mul(b, input(b, extent), number(b, 0.5f)); }

/// How far the end of a direction gets within the cone: a solid angle W is that of the chord
/// root(W / pi) of the unit sphere.
ValueId withinCone(Builder &b, const Triple &direction) {
    const ValueId squared = dot(b, direction, direction);
    const ValueId chord =
        mul(b, input(b, ShaderInput::Dw), number(b, std::numbers::inv_pi_v<float>));
    return sqrt(b, mul(b, squared, chord));
}

ValueId offOf(Builder &b, const Row &row) {
    if (row.first == ShaderInput::Ps)
        return withinCone(b, sub(b, input3(b, ShaderInput::Ps), input3(b, ShaderInput::P)));
    if (row.first == ShaderInput::Ns) // Whoever asks: anything.
        return number(b, std::numeric_limits<float>::infinity());
    const ValueId rest = input(b, row.rest);
    return row.first == ShaderInput::I ? add(b, rest, withinCone(b, input3(b, ShaderInput::I)))
                                       : rest;
}

} // namespace

bool inputVaries(int plane) { return isParameter(plane) || rowOf(plane); }

FormParts inputForm(Builder &b, int plane) {
    const ValueId middle = input(b, ShaderInput(plane)), zero = number(b, 0);
    ValueId alongU = zero, alongV = zero, off = zero;
    if (isParameter(plane)) {
        (plane == int(ShaderInput::u) ? alongU : alongV) =
            halfOf(b, plane == int(ShaderInput::u) ? ShaderInput::Du : ShaderInput::Dv);
    } else {
        const Row &row = *rowOf(plane);
        const int component = plane - int(row.first);
        off = offOf(b, row);
        if (row.byU != none) {
            alongU = mul(b, input(b, row.byU, component), halfOf(b, ShaderInput::Du));
            alongV = mul(b, input(b, row.byV, component), halfOf(b, ShaderInput::Dv));
        }
    }
    const auto size = [&](ValueId x) { return unary(b, Op::Abs, x); };
    const ValueId spread = add(b, add(b, size(alongU), size(alongV)), off);
    const ValueId isSame = equal(b, spread, zero);
    const float endless = std::numeric_limits<float>::infinity();
    return callBound(
        b, RuntimeFunction::bound_settle,
        {{middle, FormParts{alongU, alongV, off, select(b, isSame, middle, number(b, -endless)),
                            select(b, isSame, middle, number(b, endless))}}},
        {size(middle)});
}

} // namespace candela::ir
