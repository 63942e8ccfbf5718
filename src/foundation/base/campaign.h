// SPDX-License-Identifier: Apache-2.0
// Tests on random programs try a few of them each time, and many in a campaign (make test-long).
#pragma once

#include <algorithm>
#include <cstdlib>

namespace candela {

/// How many times as many cases as usual: $CANDELA_CAMPAIGN, else 1.
inline unsigned campaignFactor() {
    const char *factor = std::getenv("CANDELA_CAMPAIGN");
    return factor ? unsigned(std::max(1, std::atoi(factor))) : 1;
}

} // namespace candela
