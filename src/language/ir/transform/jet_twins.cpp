// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet_twins.h"

#include "language/ir/core/builder_services.h"

namespace candela::ir {

Values askTwin(Builder &b, const ServiceUse &use, const Values &operands) {
    return queryOther(b, twinOf(*use.info), use, operands, use.results * (1 + twinCoordinates));
}

std::vector<Jet> ofTwin(Jets &jets, const std::vector<Jet> &operands, const Values &results) {
    const size_t values = results.size() / size_t(1 + twinCoordinates);
    std::vector<Jet> all;
    for (size_t k = 0; k < values; ++k) {
        Jet change = jets.series({});
        for (size_t c = 0; c < size_t(twinCoordinates); ++c) {
            Jet derivative = jets.standing(results[(c + 1) * values + k]);
            change = sum(jets, change, integral(jets, operands[c], derivative));
        }
        all.push_back(jets.standing(results[k]));
        all.back()->rule = change->rule;
    }
    return all;
}

} // namespace candela::ir
