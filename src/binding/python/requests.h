// SPDX-License-Identifier: Apache-2.0
// The calls of the interface, one for each request of the table. Private to the room.
#pragma once

#include <pybind11/pybind11.h>

namespace candela::python {

void addRequests(pybind11::module_ &);

} // namespace candela::python
