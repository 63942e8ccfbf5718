// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet_sources.h"

namespace candela::ir {

namespace {

struct Row {
    ShaderInput first, last, byU, byV;
};

// I runs from the eye, which stands still while u and v move P.
constexpr Row rows[] = {
    {ShaderInput::P, ShaderInput::PLast_, ShaderInput::dPdu, ShaderInput::dPdv},
    {ShaderInput::I, ShaderInput::ILast_, ShaderInput::dPdu, ShaderInput::dPdv},
    {ShaderInput::N, ShaderInput::NLast_, ShaderInput::dNdu, ShaderInput::dNdv},
    {ShaderInput::Ng, ShaderInput::NgLast_, ShaderInput::dNgdu, ShaderInput::dNgdv},
    {ShaderInput::s, ShaderInput::sLast_, ShaderInput::dsdu, ShaderInput::dsdv},
    {ShaderInput::t, ShaderInput::tLast_, ShaderInput::dtdu, ShaderInput::dtdv},
    {ShaderInput::Cs, ShaderInput::CsLast_, ShaderInput::dCsdu, ShaderInput::dCsdv},
    {ShaderInput::Os, ShaderInput::OsLast_, ShaderInput::dOsdu, ShaderInput::dOsdv},
};

struct Range {
    ShaderInput first, last;
};
constexpr Range still[] = {{ShaderInput::E, ShaderInput::ELast_},
                           {ShaderInput::orientation, ShaderInput::orientation},
                           {ShaderInput::time, ShaderInput::time},
                           {ShaderInput::Ps, ShaderInput::IsLast_},
                           {ShaderInput::lightSample, ShaderInput::lightSampleLast_},
                           {ShaderInput::seed, ShaderInput::seed}};

} // namespace

InputSlope inputSlope(int plane) {
    if (plane == int(ShaderInput::u) || plane == int(ShaderInput::v))
        return {InputSlope::Parameter, plane == int(ShaderInput::u), plane == int(ShaderInput::v)};
    for (const Row &row : rows)
        if (plane >= int(row.first) && plane <= int(row.last)) {
            const int component = plane - int(row.first);
            return {InputSlope::Plane, int(row.byU) + component, int(row.byV) + component};
        }
    for (const Range &range : still)
        if (plane >= int(range.first) && plane <= int(range.last))
            return {InputSlope::Still, 0, 0};
    return {InputSlope::Unknown, 0, 0};
}

} // namespace candela::ir
