// SPDX-License-Identifier: Apache-2.0
// Hands on the frames that are wanted, and all that stands in no frame.
#pragma once

#include "interface/ri/forwarding_sink.h"

#include <utility>
#include <vector>

namespace candela {

/// Numbers of frames: ranges from the first to the last of each.
using FrameNumbers = std::vector<std::pair<int, int>>;

/// "1-10,20"; nothing if it is none.
std::optional<FrameNumbers> parseFrameNumbers(const std::string &);

class FrameChooser final : public ForwardingSink {
public:
    /// The sink must outlive it.
    FrameChooser(RequestSink &, FrameNumbers wanted);

    void frameBegin(const SourceLocation &, int number) override;
    /// Of the numbers, those of which no frame has come.
    FrameNumbers missing() const;

protected:
    bool admits(RequestId) override;

private:
    FrameNumbers wanted_;
    std::vector<bool> found_; ///< Of each range.
    bool isSkipping_ = false;
};

} // namespace candela
