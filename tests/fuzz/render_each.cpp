// SPDX-License-Identifier: Apache-2.0
// Renders scenes one after the other in this process: starting candela anew for each would take
// most of a campaign's time. The argument is the MiB of memory that it may take. A line of standard
// input is a folder with a scene.rib, the seconds of the processor that it may take, and the folder
// of its shader cache (empty: the common one), with tabs between them. For each a line of standard
// output is the exit status that candela would have; its messages are left in the folder's file
// "said".
#include "render/render.h"

#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

namespace {

struct Task {
    std::string folder, seconds, cache;
};

Task parse(const std::string &line) {
    std::istringstream words(line);
    Task task;
    std::getline(words, task.folder, '\t');
    std::getline(words, task.seconds, '\t');
    std::getline(words, task.cache, '\t');
    return task;
}

void limit(int resource, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(resource, &both);
}

/// Bytes of writable memory of its own that this process has mapped. Sanitizers map terabytes for
/// their shadow and touch little of it, so that limits have to be set from here.
rlim_t mappedData() {
    std::ifstream file("/proc/self/statm");
    rlim_t pages[6] = {};
    for (rlim_t &count : pages)
        file >> count;
    return pages[5] * rlim_t(sysconf(_SC_PAGESIZE));
}

/// The process may still take so many seconds of the processor, or ten times as many of the clock:
/// then SIGPROF or SIGALRM ends it. 0: any.
void allow(long seconds) {
    const itimerval processor{{0, 0}, {seconds, 0}}, clock{{0, 0}, {10 * seconds, 0}};
    setitimer(ITIMER_PROF, &processor, nullptr);
    setitimer(ITIMER_REAL, &clock, nullptr);
}

/// The exit status.
int render(const Task &task, const std::string &commonCache) {
    const int said = creat((task.folder + "/said").c_str(), 0600);
    if (said < 0 || chdir(task.folder.c_str()) != 0)
        return 2;
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    close(said);
    setenv("CANDELA_CACHE", (task.cache.empty() ? commonCache : task.cache).c_str(), 1);
    candela::RenderSettings settings;
    settings.samplesPerPixel = 1;
    settings.resolution = {8, 8};
    settings.threads = 1;
    settings.quiet = true;
    const long seconds = std::strtol(task.seconds.c_str(), nullptr, 10);
    allow(seconds);
    const int status = candela::renderFiles({"scene.rib"}, settings);
    allow(0);
    std::fflush(stdout);
    return status;
}

} // namespace

int main(int count, char **words) {
    const rlim_t mebibytes = count > 1 ? std::strtoul(words[1], nullptr, 10) : 4096;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, rlim_t(1) << 28);
    limit(RLIMIT_DATA, mappedData() + (mebibytes << 20));
    const char *cache = std::getenv("CANDELA_CACHE");
    const std::string commonCache = cache ? cache : "";
    const int answers = dup(STDOUT_FILENO); // Shaders print to standard output.
    for (std::string line; std::getline(std::cin, line);) {
        const std::string status = std::to_string(render(parse(line), commonCache)) + "\n";
        if (write(answers, status.data(), status.size()) < 0)
            return 2;
    }
    return 0;
}
