// SPDX-License-Identifier: Apache-2.0
// LLVM ends the process when it meets what it can't compile or when memory runs out. Here such an
// end becomes an error to report.
#pragma once

#include <functional>
#include <string>

namespace candela {

/// Runs the work; returns what LLVM would have ended the process with, or that memory has run out;
/// empty if the work was done. After an error nothing that the work used may be touched again, not
/// even to be freed: LLVM has left it as it was.
std::string runGuarded(const std::function<void()> &work);

} // namespace candela
