// SPDX-License-Identifier: Apache-2.0
// Pictures of what moves beside the mean of pictures of it at times.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

namespace candela::test {

/// A request with these numbers, on a line.
std::string request(const std::string &name, std::initializer_list<double> numbers);
/// Numbers in brackets.
std::string array(std::initializer_list<double> numbers);

/// The world, seen along +z over [-1,1] x [-1,1] with a motion block in the place of each line "@",
/// is the mean of pictures with what `at` says of a share of the shutter's interval in that place.
/// The block has what it says of the beginning and of the end.
void expectMeanOfStills(const std::string &integrator, const std::string &world,
                        const std::function<std::string(double share)> &at);

} // namespace candela::test
