// SPDX-License-Identifier: Apache-2.0
// For pilots: takes what they bring and forgets it.
#pragma once

#include "world/scene/sample_sink.h"

namespace candela {

class NoPicture : public SampleSink {
public:
    std::span<const ChannelInfo> channels() const override { return {}; }
    void add(const SampleBatch &) override {}
    void add(const SplatBatch &) override {}
};

} // namespace candela
