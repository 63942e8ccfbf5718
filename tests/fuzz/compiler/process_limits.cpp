// SPDX-License-Identifier: Apache-2.0
#include "process_limits.h"

#include <fstream>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace candela::fuzz {

static itimerval timer(double seconds) {
    const auto whole = time_t(seconds);
    return {{0, 0}, {whole, suseconds_t((seconds - double(whole)) * 1e6)}};
}

double allowSeconds(double seconds) {
    const itimerval processor = timer(seconds), clock = timer(10 * seconds);
    itimerval before{};
    setitimer(ITIMER_PROF, &processor, &before);
    setitimer(ITIMER_REAL, &clock, nullptr);
    return double(before.it_value.tv_sec) + double(before.it_value.tv_usec) * 1e-6;
}

void allowMemory(std::size_t mebibytes) {
    std::ifstream file("/proc/self/statm");
    rlim_t pages[6] = {};
    for (rlim_t &count : pages)
        file >> count;
    rlimit limit{};
    getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = pages[5] * rlim_t(sysconf(_SC_PAGESIZE)) + (rlim_t(mebibytes) << 20);
    setrlimit(RLIMIT_DATA, &limit);
}

} // namespace candela::fuzz
