// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/request_table.h"

namespace candela {

namespace {

// One array of argument names a request. The empty string at the end makes room for requests
// without arguments; it is not counted.
#define ARGUMENTS_OF(Name, ...)                                                                    \
    constexpr std::string_view argumentsOf##Name[] = {CANDELA_ARGUMENT_NAMES(__VA_ARGS__) ""};
#define REQUEST(Name, handler, scopes, ...) ARGUMENTS_OF(Name, __VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) ARGUMENTS_OF(Name, __VA_ARGS__)
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...) ARGUMENTS_OF(Name, __VA_ARGS__)
#define REQUEST_OF_STREAM(Name, handler, scopes, ...) ARGUMENTS_OF(Name, __VA_ARGS__)
#include "interface/ri/requests.def"

template <int N> constexpr auto withoutLast(const std::string_view (&names)[N]) {
    return std::span<const std::string_view>(names, N - 1);
}

constexpr RequestDescription table[] = {
#define REQUEST(Name, handler, scopes, ...) {#Name, scopes, withoutLast(argumentsOf##Name)},
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    {#Name, scopes, withoutLast(argumentsOf##Name)},
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...)                                              \
    {#Name, scopes, withoutLast(argumentsOf##Name)},
#define REQUEST_OF_STREAM(Name, handler, scopes, ...)                                              \
    {#Name, scopes, withoutLast(argumentsOf##Name)},
#include "interface/ri/requests.def"
};

} // namespace

std::span<const RequestDescription> requestTable() { return table; }

} // namespace candela
