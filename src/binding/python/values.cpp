// SPDX-License-Identifier: Apache-2.0
#include "binding/python/values.h"

#include <limits>

namespace candela::python {

namespace {

/// An array of numbers, or nothing: neither texts nor what NumPy can only take as objects.
std::optional<py::array> numbersOf(py::handle value) {
    if (py::isinstance<py::str>(value) || py::isinstance<py::dict>(value) || value.is_none())
        return std::nullopt;
    py::array array = py::array::ensure(value);
    if (!array) {
        PyErr_Clear(); // Rows of different lengths.
        return std::nullopt;
    }
    const char kind = array.dtype().kind();
    const bool empty = array.size() == 0,
               number = std::string_view("biuf").find(kind) != std::string_view::npos;
    return number || empty ? std::optional(array) : std::nullopt;
}

template <class Number>
using Dense = py::array_t<Number, py::array::c_style | py::array::forcecast>;

} // namespace

std::string kindOf(py::handle value) {
    return value ? "'" + std::string(Py_TYPE(value.ptr())->tp_name) + "'" : "nothing";
}

std::optional<std::string> textOf(py::handle value) {
    if (!py::isinstance<py::str>(value))
        return std::nullopt;
    return value.cast<std::string>();
}

std::optional<Strings> textsOf(py::handle value) {
    if (const auto text = textOf(value))
        return Strings{*text};
    if (!py::isinstance<py::sequence>(value) && !py::isinstance<py::array>(value))
        return std::nullopt;
    Strings all;
    for (const py::handle each : py::reinterpret_borrow<py::object>(value)) {
        const auto text = textOf(each);
        if (!text)
            return std::nullopt;
        all.push_back(*text);
    }
    return all;
}

std::optional<Floats> floatsOf(py::handle value) {
    const auto numbers = numbersOf(value);
    if (!numbers)
        return std::nullopt;
    const auto dense = Dense<float>::ensure(*numbers);
    return Floats(dense.data(), dense.data() + dense.size());
}

std::optional<Integers> integersOf(py::handle value) {
    const auto numbers = numbersOf(value);
    if (!numbers || (numbers->dtype().kind() == 'f' && numbers->size() > 0))
        return std::nullopt;
    if (py::isinstance<py::array_t<int>>(*numbers)) {
        const auto dense = Dense<int>::ensure(*numbers);
        return Integers(dense.data(), dense.data() + dense.size());
    }
    const auto dense = Dense<std::int64_t>::ensure(*numbers);
    Integers all;
    all.reserve(std::size_t(dense.size()));
    for (py::ssize_t i = 0; i < dense.size(); ++i) {
        const std::int64_t number = dense.data()[i];
        if (number < std::numeric_limits<int>::min() || number > std::numeric_limits<int>::max())
            return std::nullopt;
        all.push_back(int(number));
    }
    return all;
}

} // namespace candela::python
