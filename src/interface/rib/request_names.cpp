// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/request_names.h"

#include "foundation/base/suggestion.h"

#include <unordered_map>
#include <vector>

namespace candela {

std::optional<RequestId> requestNamed(std::string_view name) {
    static const auto ids = [] {
        std::unordered_map<std::string_view, RequestId> result;
        const auto table = requestTable();
        for (std::size_t i = 0; i < table.size(); ++i)
            result.emplace(table[i].name, RequestId(i));
        return result;
    }();
    auto found = ids.find(name);
    return found == ids.end() ? std::nullopt : std::optional(found->second);
}

std::string requestSuggestion(const std::string &name) {
    std::vector<std::string> names;
    for (const RequestDescription &request : requestTable())
        names.emplace_back(request.name);
    return suggestion(name, names);
}

} // namespace candela
