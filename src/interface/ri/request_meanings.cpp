// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/request_meanings.h"

#include <map>

namespace candela {

std::string_view meaningOf(RequestId id) {
    static const std::map<RequestId, std::string_view> meanings = {
#define MEANING(Name, text) {RequestId::Name, text},
#include "interface/ri/request_meanings.def"
    };
    const auto found = meanings.find(id);
    return found == meanings.end() ? std::string_view() : found->second;
}

} // namespace candela
