// SPDX-License-Identifier: Apache-2.0
#include "binding/python/arguments.h"

#include "binding/python/values.h"
#include "interface/ri/wide_integers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela::python {

Arguments::Arguments(const RequestDescription &request, py::args values, py::kwargs keywords)
    : request_(request), values_(std::move(values)), keywords_(py::dict(keywords)) {}

std::string Arguments::argumentName() const {
    return std::string(request_.argumentNames[std::size_t(argument_)]);
}

void Arguments::fail(const std::string &expected, py::handle found) const {
    throw py::type_error(std::string(request_.name) + ": expected " + expected + " for '" +
                         argumentName() + "', not " + kindOf(found));
}

py::handle Arguments::peek() const {
    return position_ < values_.size() ? py::handle(values_[position_]) : py::handle();
}

py::object Arguments::keyword(const char *name) {
    if (!keywords_.contains(name))
        return {};
    py::object value = keywords_[name];
    PyDict_DelItemString(keywords_.ptr(), name);
    return value;
}

py::object Arguments::next() {
    if (position_ < values_.size())
        return values_[position_++];
    if (py::object value = keyword(argumentName().c_str()))
        return value;
    throw py::type_error(std::string(request_.name) + ": the argument '" + argumentName() +
                         "' is missing");
}

bool Arguments::hasNumber() const {
    return !numbers_.empty() || (peek() && !py::isinstance<py::dict>(peek()) && !textOf(peek()));
}

double Arguments::nextNumber() {
    if (numbers_.empty()) {
        const py::object value = next();
        if (PyFloat_Check(value.ptr()) || PyLong_Check(value.ptr()))
            return value.cast<double>();
        const auto numbers = floatsOf(value);
        if (!numbers || numbers->empty())
            fail("a number", value);
        numbers_.assign(numbers->begin(), numbers->end());
    }
    const double number = numbers_.front();
    numbers_.pop_front();
    return number;
}

void Arguments::addParameter(TokenList &list, const std::string &token, py::handle value) const {
    TokenValue parameter{token, where, {}, {}};
    if (auto texts = textsOf(value); texts && !texts->empty())
        parameter.strings = std::move(*texts);
    else if (auto numbers = floatsOf(value))
        parameter.floats = std::move(*numbers);
    else
        throw py::type_error(std::string(request_.name) + ": expected numbers or strings for '" +
                             token + "', not " + kindOf(value));
    if (const auto integers = integersOf(value))
        parameter.integers = wideIntegers(*integers);
    list.all.push_back(std::move(parameter));
}

TokenList Arguments::parameters() {
    TokenList list;
    while (position_ < values_.size()) {
        const py::object token = values_[position_++];
        if (py::isinstance<py::dict>(token)) {
            for (const auto &[name, value] : py::reinterpret_borrow<py::dict>(token))
                addParameter(list, py::str(name), value);
            continue;
        }
        const auto name = textOf(token);
        if (!name)
            fail("a dictionary, or the token of a parameter,", token);
        if (position_ == values_.size())
            throw py::type_error(std::string(request_.name) + ": the value of '" + *name +
                                 "' is missing");
        addParameter(list, *name, values_[position_++]);
    }
    for (const auto &[name, value] : keywords_)
        addParameter(list, py::str(name), value);
    keywords_.clear();
    return list;
}

void Arguments::finish() {
    if (!numbers_.empty() || position_ < values_.size())
        throw py::type_error(std::string(request_.name) + ": there are too many arguments");
    if (!keywords_.empty())
        throw py::type_error(std::string(request_.name) + ": it has no argument '" +
                             std::string(py::str(keywords_.begin()->first)) + "'");
}

void read(Arguments &arguments, float &value) { value = float(arguments.nextNumber()); }

void read(Arguments &arguments, int &value) {
    const double number = arguments.nextNumber();
    if (number != std::floor(number) || std::fabs(number) > std::numeric_limits<int>::max())
        arguments.fail("a whole number", py::float_(number));
    value = int(number);
}

void read(Arguments &arguments, bool &value) {
    value = PyObject_IsTrue(arguments.next().ptr()) == 1;
}

void read(Arguments &arguments, std::string &value) {
    const py::object given = arguments.next();
    const auto text = textOf(given);
    if (!text)
        arguments.fail("a string", given);
    value = *text;
}

void read(Arguments &arguments, Handle &value) {
    const py::object given = arguments.next();
    if (!textOf(given) && !PyLong_Check(given.ptr()))
        arguments.fail("a handle", given);
    value.text = py::str(given);
}

void read(Arguments &arguments, candela::Color &value) {
    float numbers[3];
    for (float &number : numbers)
        read(arguments, number);
    value = candela::Color(numbers[0], numbers[1], numbers[2]);
}

void read(Arguments &arguments, Matrix4 &value) {
    for (float &number : value.m)
        read(arguments, number);
}

void read(Arguments &arguments, BasisArgument &value) {
    if (const auto name = arguments.peek() ? textOf(arguments.peek()) : std::nullopt) {
        arguments.next();
        value = *name;
        return;
    }
    std::array<float, 16> numbers{};
    for (float &number : numbers)
        read(arguments, number);
    value = numbers;
}

/// An argument that `convert` can take.
template <class Value, class Convert>
static void readWith(Arguments &arguments, Value &value, Convert convert, const char *expected) {
    const py::object given = arguments.next();
    auto converted = convert(given);
    if (!converted)
        arguments.fail(expected, given);
    value = std::move(*converted);
}

void read(Arguments &arguments, Floats &value) { readWith(arguments, value, floatsOf, "numbers"); }
void read(Arguments &arguments, Integers &value) {
    readWith(arguments, value, integersOf, "whole numbers");
}
void read(Arguments &arguments, Strings &value) { readWith(arguments, value, textsOf, "strings"); }

void read(Arguments &arguments, LooseFloats &value) {
    while (arguments.hasNumber())
        value.values.push_back(float(arguments.nextNumber()));
}

void read(Arguments &arguments, SubdivisionTags &value) {
    const py::handle given = arguments.peek();
    if (!given || py::isinstance<py::dict>(given) || textOf(given))
        return;
    read(arguments, value.names);
    read(arguments, value.argumentCounts);
    read(arguments, value.integers);
    read(arguments, value.floats);
}

void read(Arguments &arguments, TokenList &value) { value = arguments.parameters(); }

} // namespace candela::python
