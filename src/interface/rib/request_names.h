// SPDX-License-Identifier: Apache-2.0
// The names of requests, as RIB spells them.
#pragma once

#include "interface/ri/request_table.h"

#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// Nothing if no request has that name.
std::optional<RequestId> requestNamed(std::string_view name);
/// What it may have been meant to be, in words that go behind a message; empty if nothing is near.
std::string requestSuggestion(const std::string &name);

} // namespace candela
