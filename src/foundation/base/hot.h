// SPDX-License-Identifier: Apache-2.0
// CANDELA_HOT before a function compiles it once for each level of vector instructions; the
// loader picks the best. Contraction is off everywhere, so all of them give the same bits.
#pragma once

#if defined(__SANITIZE_THREAD__) || defined(__SANITIZE_ADDRESS__)
#define CANDELA_HOT // The loader's choice runs before the sanitizers are set up.
#define CANDELA_PLAIN
#else
#define CANDELA_HOT                                                                                \
    __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"),                   \
                   optimize("O3", "no-trapping-math")))
// For the few loops that are written twice: with AVX-512 instructions and in plain C++.
#define CANDELA_WIDE __attribute__((target("arch=x86-64-v4")))
#define CANDELA_PLAIN __attribute__((target("default")))
#endif
