// SPDX-License-Identifier: Apache-2.0
// Who takes the pictures of displays beside files, or in place of them: a program that has called,
// a window.
#pragma once

#include "image/picture.h"

#include <string>

namespace candela {

class DisplayTaker {
public:
    virtual ~DisplayTaker() = default;

    enum class Interest { None, Beside, Instead }; ///< Of a file.
    /// In displays of that type (in small letters). Asked before the first sample.
    virtual Interest interestIn(const std::string &type) = 0;
    /// A display's picture: finished, or as it is by now, without filters and imager.
    virtual void take(const std::string &display, Picture, bool isFinished) = 0;
    /// Whether pictures that are not finished are wanted at all.
    virtual bool wantsUnfinished() const { return false; }
    /// Whether the user has had enough: the render ends as by Ctrl-C.
    virtual bool wantsEnd() const { return false; }
};

} // namespace candela
