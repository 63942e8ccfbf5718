// SPDX-License-Identifier: Apache-2.0
// What the requests have to say to the user: who asks for what cannot be done hears of it with the
// request's name, and of what this version leaves undone once. Private to the room.
#pragma once

#include "interface/ri/error_policy.h"

#include <initializer_list>
#include <set>
#include <span>
#include <string>

namespace candela {

class RequestDiagnostics {
public:
    /// The policy must outlive it.
    explicit RequestDiagnostics(ErrorPolicy &policy) : policy_(policy) {}

    ErrorPolicy &policy() { return policy_; }
    void error(const SourceLocation &, const char *request, const std::string &message);
    void warning(const SourceLocation &, const char *request, const std::string &message);
    /// The first time that this `about` comes up, and never again.
    bool isNew(const std::string &about) { return known_.insert(about).second; }
    /// If `about` is new; `message` names the request itself.
    void warnOnce(const SourceLocation &, const std::string &about, const std::string &message);

    /// True if all are finite; reports it otherwise.
    bool finite(const SourceLocation &, const char *request, std::initializer_list<float>);
    /// To [0,1], with a warning where that changes `what`.
    void clampOpacity(const SourceLocation &, const char *what, std::span<float> values);

private:
    ErrorPolicy &policy_;
    std::set<std::string> known_; ///< What has come up.
};

} // namespace candela
