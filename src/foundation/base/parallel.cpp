// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/parallel.h"

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

void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body) {
    tbb::parallel_for(std::size_t(0), count, body, tbb::simple_partitioner());
}

} // namespace candela
