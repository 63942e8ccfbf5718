// SPDX-License-Identifier: Apache-2.0
// CANDELA_HOT before a plain function with structure-of-arrays loops: it is compiled for several
// vector widths and the machine picks one. Contraction is off everywhere, so all clones agree bit
// by bit.
#pragma once

// Sanitizers instrument the resolvers, which run before their runtime is up.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CANDELA_HOT                                                                                \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define CANDELA_HOT
#endif
