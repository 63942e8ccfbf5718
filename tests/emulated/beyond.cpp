// SPDX-License-Identifier: Apache-2.0
// beyond v2|v3: executes an instruction of the level above, which a processor of the level named
// must refuse; an emulator that let it pass would prove nothing. Exit status 0 if it is refused.
#include <csignal>
#include <cstdio>
#include <cstring>
#include <unistd.h>

int main(int count, char **words) {
    if (count != 2 || (std::strcmp(words[1], "v2") != 0 && std::strcmp(words[1], "v3") != 0)) {
        std::fputs("beyond v2|v3\n", stderr);
        return 2;
    }
    std::signal(SIGILL, [](int) { _exit(0); });
    if (std::strcmp(words[1], "v2") == 0)
        asm volatile("vpaddd %%ymm0, %%ymm0, %%ymm0" ::: "xmm0"); // AVX2
    else
        asm volatile("vpaddd %%zmm16, %%zmm16, %%zmm16" ::: "memory"); // AVX-512
    std::fprintf(stderr, "an instruction beyond %s was executed\n", words[1]);
    return 1;
}
