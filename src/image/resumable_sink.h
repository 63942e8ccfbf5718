// SPDX-License-Identifier: Apache-2.0
// A sink that can be written down while it is filled, and filled further in another run.
#pragma once

#include "world/scene/sample_sink.h"

#include <string>
#include <string_view>

namespace candela {

class ResumableSink : public SampleSink {
public:
    /// Adds all that it holds, as the bytes of this machine. Nothing may be added meanwhile.
    virtual void save(std::string &bytes) const = 0;
    /// Takes what a sink of the same settings has saved from the front of `bytes`. False if there
    /// is too little; the sink is then of no use.
    virtual bool restore(std::string_view &bytes) = 0;
};

} // namespace candela
