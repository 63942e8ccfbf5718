// SPDX-License-Identifier: Apache-2.0
// Pictures as NumPy has them. Private to the room.
#pragma once

#include <pybind11/pybind11.h>

namespace candela::python {

/// The class Picture, and picture().
void addPictures(pybind11::module_ &);

} // namespace candela::python
