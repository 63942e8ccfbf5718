// SPDX-License-Identifier: Apache-2.0
// Requests and their arguments as bytes of RIB, ASCII or binary. Private to the room.
#pragma once

#include "interface/ri/request_types.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace candela {

class RibEncoder {
public:
    static std::unique_ptr<RibEncoder> ascii();
    static std::unique_ptr<RibEncoder> binary();
    virtual ~RibEncoder() = default;

    /// One that stands in so many blocks.
    virtual void begin(std::string_view request, int depth) = 0;
    virtual void end() = 0;
    virtual void comment(const std::string &text) = 0;

    virtual void number(float) = 0;
    virtual void number(int) = 0;
    virtual void string(const std::string &) = 0;
    /// The name of a parameter: the same ones come again and again.
    virtual void token(const std::string &) = 0;
    virtual void array(std::span<const float>) = 0;
    virtual void array(std::span<const int>) = 0;
    virtual void array(const Strings &) = 0;

    /// What has been encoded and not been taken from here.
    std::string bytes;
};

} // namespace candela
