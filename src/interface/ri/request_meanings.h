// SPDX-License-Identifier: Apache-2.0
// What requests do, in a sentence each, for those who ask.
#pragma once

#include "interface/ri/request_table.h"

namespace candela {

/// Empty for requests of other renderers.
std::string_view meaningOf(RequestId);

} // namespace candela
