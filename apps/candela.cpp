// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <cstring>

int main(int argc, char **argv) {
    if (argc == 2 && std::strcmp(argv[1], "--version") == 0) {
        std::printf("candela %s\n", CANDELA_VERSION);
        return 0;
    }
    return 1;
}
