// SPDX-License-Identifier: Apache-2.0
// OpenImageIO's readers believe their files, and throw where that asks for too much.
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace candela {

/// What the work gives; if it throws, nothing (as its type has it), and `problem` says why.
template <class Work> auto guarded(std::string &problem, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        problem = "it asks for more memory than there is";
    } catch (const std::length_error &) {
        problem = "it asks for more memory than there can be";
    } catch (const std::exception &failure) {
        problem = failure.what();
    }
    return {};
}

} // namespace candela
