// SPDX-License-Identifier: Apache-2.0
// Limits of this process on time and memory.
#pragma once

#include <cstddef>

namespace candela::fuzz {

/// The process may still take so many seconds of the processor, or ten times as many of the clock:
/// then SIGPROF or SIGALRM ends it. 0: any. Gives how many were left of the processor's.
double allowSeconds(double);

/// The process may map so many MiB more than it has now. Sanitizers map terabytes for their shadow
/// and touch little of it, so that it counts from here.
void allowMemory(std::size_t mebibytes);

} // namespace candela::fuzz
