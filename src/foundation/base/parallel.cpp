// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/parallel.h"

#include <atomic>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace candela {

ThreadLimit::ThreadLimit(int threads) {
    std::size_t limit = threads > 0 ? threads : tbb::this_task_arena::max_concurrency();
    control_ = new tbb::global_control(tbb::global_control::max_allowed_parallelism, limit);
}

ThreadLimit::~ThreadLimit() { delete static_cast<tbb::global_control *>(control_); }

int threadCount() {
    return int(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

#ifdef __SANITIZE_THREAD__
// The sanitizer cannot see how TBB, built without it, hands work out and waits for its end: what
// came before all calls, and what comes after them, is told here.
void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body) {
    std::atomic<int> begun{0}, ended{0};
    begun.store(1, std::memory_order_release);
    const auto told = [&](std::size_t i) {
        begun.load(std::memory_order_acquire);
        body(i);
        ended.fetch_add(1, std::memory_order_acq_rel);
    };
    tbb::parallel_for(std::size_t(0), count, told, tbb::simple_partitioner());
    ended.load(std::memory_order_acquire);
}
#else
void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body) {
    tbb::parallel_for(std::size_t(0), count, body, tbb::simple_partitioner());
}
#endif

} // namespace candela
