// SPDX-License-Identifier: Apache-2.0
// The names of requests, as RIB spells them.
#pragma once

#include "interface/ri/request_table.h"

#include <optional>
#include <string_view>

namespace candela {

/// Nothing if no request has that name.
std::optional<RequestId> requestNamed(std::string_view name);

} // namespace candela
