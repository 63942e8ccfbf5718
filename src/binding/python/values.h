// SPDX-License-Identifier: Apache-2.0
// Values of Python as those of requests. Arrays of float32 and int32 are read where they lie,
// others are converted by NumPy. Nothing where a value is of another kind. Private to the room.
#pragma once

#include "interface/ri/request_types.h"

#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace candela::python {

namespace py = pybind11;

std::optional<std::string> textOf(py::handle);
/// A list or tuple of strings, or one string.
std::optional<Strings> textsOf(py::handle);
/// A number, or numbers in sequences and arrays of any shape, in the order of their rows.
std::optional<Floats> floatsOf(py::handle);
/// Whole numbers that fit in 32 bits, likewise.
std::optional<Integers> integersOf(py::handle);
/// "a list", for messages.
std::string kindOf(py::handle);

} // namespace candela::python
