// SPDX-License-Identifier: Apache-2.0
// For sinks that take a whole stream as it stands and keep no state that it could ask for.
#pragma once

#include "interface/ri/stream_sink.h"

namespace candela {

class StatelessSink : public StreamSink {
public:
    bool skips() const override { return false; }
    bool stopped() const override { return false; }
    std::optional<StateValue> valueOf(const std::string &) const override { return std::nullopt; }
    std::optional<std::string> locate(const char *, const std::string &,
                                      const SourceLocation &) const override {
        return std::nullopt;
    }
    std::optional<Matrix4d> cameraFrom(const std::string &) const override { return std::nullopt; }
    float detailOf(const std::array<float, 6> &) const override { return 0; }
};

} // namespace candela
