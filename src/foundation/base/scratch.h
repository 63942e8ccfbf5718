// SPDX-License-Identifier: Apache-2.0
// Bytes of a thread's own, kept from call to call so that hot paths do not allocate.
#pragma once

#include "foundation/base/planes.h"

#include <deque>
#include <vector>

namespace candela {

template <class T> class Scratch {
public:
    /// Room for `count` values; what was there is lost if it grows.
    T *get(std::size_t count) {
        if (values_.size() < count)
            values_.resize(count + count / 2);
        return values_.data();
    }

private:
    std::vector<T> values_;
};

/// Floats that begin at 64 bytes, as planes do.
class AlignedScratch {
public:
    float *get(std::size_t count) {
        if (std::size_t(storage_.lanes()) < count)
            storage_ = Planes<float>(1, int(count + count / 2));
        return storage_[0];
    }

private:
    Planes<float> storage_{1, laneBlock};
};

/// Of a thread's own, one for each level at which code that needs it is called from within itself.
template <class T> class ScratchLevels {
public:
    /// Holds one for as long as it lives.
    class Level {
    public:
        explicit Level(ScratchLevels &all) : all_(all) {
            if (all_.depth_ == all_.levels_.size())
                all_.levels_.emplace_back();
            value_ = &all_.levels_[all_.depth_++];
        }
        ~Level() { --all_.depth_; }
        Level(const Level &) = delete;
        T &operator*() const { return *value_; }
        T *operator->() const { return value_; }

    private:
        ScratchLevels &all_;
        T *value_;
    };

private:
    std::deque<T> levels_; // They stay where they are.
    std::size_t depth_ = 0;
};

} // namespace candela
