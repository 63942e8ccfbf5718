// SPDX-License-Identifier: Apache-2.0
// Work on several threads. TBB stands behind this door alone.
#pragma once

#include <cstddef>
#include <functional>

namespace candela {

/// Bounds the number of threads for as long as it lives; 0 = all cores.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit &) = delete;

private:
    void *control_;
};

/// The number of threads that parallelFor may use now.
int threadCount();

/// Calls body(i) once for every i in [0, count), on any thread, in any order. What a body
/// throws (std::bad_alloc) comes out of here once the others have ended; calls not yet begun are
/// left out. Flush-to-zero stays as the calling code set it on each thread.
void parallelFor(std::size_t count, const std::function<void(std::size_t)> &body);

} // namespace candela
