// SPDX-License-Identifier: Apache-2.0
// A hash of requests: equal for equal ones, in whatever encoding they have come.
#pragma once

#include "foundation/base/hash.h"
#include "interface/rib/rib_writer.h"

#include <memory>
#include <string>

namespace candela {

class RequestHash {
public:
    RequestHash() : output_(ByteOutput::toHash(hash_)), writer_(*output_, RibEncoding::Binary) {}

    /// What it is told is hashed.
    RibWriter &writer() {
        isAsked_ = false;
        return writer_;
    }
    /// Of the requests so far; the same until another one comes.
    std::string text() {
        if (!isAsked_)
            writer_.flush();
        isAsked_ = true;
        return hash_.text();
    }

private:
    bool isAsked_ = false;
    ContentHash hash_;
    std::unique_ptr<ByteOutput> output_;
    RibWriter writer_;
};

} // namespace candela
