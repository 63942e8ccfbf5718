// SPDX-License-Identifier: Apache-2.0
// Scenes that are solved first, and what --stats tells of their solutions.
#pragma once

#include <string>

namespace candela::test {

inline constexpr const char *finalPasses[] = {"fe", "fe+direct", "gather"};

/// RIB before WorldBegin: si units, a small picture, radiosity with that final pass, and more.
std::string solvedScene(const std::string &finalPass, const std::string &more = "");

/// `radiosity.NAME` of the statistics of a run, which must succeed.
double statistic(const std::string &rib, const std::string &name);

} // namespace candela::test
