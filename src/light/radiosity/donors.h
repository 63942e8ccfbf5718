// SPDX-License-Identifier: Apache-2.0
// Slivers: parts of cut elements that have no node, at the foot of what stands on them. What is
// sent there, nodes of a neighbour know.
#pragma once

#include "light/radiosity/places.h"

#include <array>

namespace candela::radiosity {

/// The receiver sees none of the sender's nodes, since it stands on the sender, but some of it: the
/// element whose nodes know what is sent there; else -1.
int donorOf(const Mesh &, int receiver, int sender, PlaceLookup &);

/// What each of the donor's nodes counts, 1 in all: those that the receiver sees.
std::array<float, mostNodes> donorWeights(const Mesh &, int receiver, int donor);

} // namespace candela::radiosity
