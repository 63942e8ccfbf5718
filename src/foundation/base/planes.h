// SPDX-License-Identifier: Apache-2.0
// Memory for batches: 64-byte aligned planes of floats or integers, padded to whole lane blocks.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace candela {

/// Widest batch step. All planes hold a multiple of this many values and are 64-byte aligned.
inline constexpr int laneBlock = 16;

/// Rounds a lane count up to whole blocks.
inline int paddedLanes(int count) { return (count + laneBlock - 1) / laneBlock * laneBlock; }

/// Plane-major storage: `planes` planes of `lanes` (padded) values each, zero at first.
template <class T> class Planes {
public:
    Planes() = default;
    Planes(int planes, int lanes) : lanes_(paddedLanes(lanes)), planes_(planes) {
        std::size_t bytes = std::size_t(planes) * lanes_ * sizeof(T);
        data_.reset(static_cast<T *>(std::aligned_alloc(64, (bytes + 63) / 64 * 64 + 64)));
        if (!data_)
            throw std::bad_alloc();
        std::memset(data_.get(), 0, bytes);
    }
    T *operator[](int plane) const { return data_.get() + std::size_t(plane) * lanes_; }
    int lanes() const { return lanes_; }
    int planes() const { return planes_; }

private:
    struct Free {
        void operator()(T *p) const { std::free(p); }
    };
    std::unique_ptr<T, Free> data_;
    int lanes_ = 0, planes_ = 0;
};

} // namespace candela
