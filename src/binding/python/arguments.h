// SPDX-License-Identifier: Apache-2.0
// The arguments of a call from Python, each read by the type that the table of requests gives it.
// What cannot be read is a TypeError that says what was expected. Private to the room.
#pragma once

#include "interface/ri/request_table.h"
#include "interface/ri/request_types.h"

#include <deque>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace candela::python {

namespace py = pybind11;

class Arguments {
public:
    Arguments(const RequestDescription &, py::args, py::kwargs);

    /// What comes next is the request's argument of that index, for messages and keywords.
    void setArgument(int index) { argument_ = index; }
    int argument() const { return argument_; }
    SourceLocation where; ///< Of the call.

    /// The value of the argument; in its place or by its name.
    py::object next();
    /// A null handle behind the last one in its place.
    py::handle peek() const;
    /// One of the request's numbers. Where a sequence or array stands, its numbers come one by one.
    double nextNumber();
    bool hasNumber() const;
    /// The parameters: a dictionary, pairs of token and value, and what is left of keywords.
    TokenList parameters();
    /// A keyword that is there; a null object otherwise.
    py::object keyword(const char *name);
    /// Whatever is left over is an error.
    void finish();

    /// Something else than `expected` stands there.
    [[noreturn]] void fail(const std::string &expected, py::handle found) const;

private:
    void addParameter(TokenList &, const std::string &token, py::handle value) const;
    std::string argumentName() const;

    const RequestDescription &request_;
    py::args values_;
    py::dict keywords_;
    std::size_t position_ = 0;
    std::deque<double> numbers_; ///< Of a sequence that has been begun.
    int argument_ = -1;
};

void read(Arguments &, float &);
void read(Arguments &, int &);
void read(Arguments &, bool &);
void read(Arguments &, std::string &);
void read(Arguments &, Handle &);
void read(Arguments &, candela::Color &);
void read(Arguments &, Matrix4 &);
void read(Arguments &, BasisArgument &);
void read(Arguments &, Floats &);
void read(Arguments &, Integers &);
void read(Arguments &, Strings &);
void read(Arguments &, LooseFloats &);
void read(Arguments &, SubdivisionTags &);
void read(Arguments &, TokenList &);

/// The one behind that which was read last.
template <class Value> void readNext(Arguments &arguments, Value &value) {
    arguments.setArgument(arguments.argument() + 1);
    read(arguments, value);
}

} // namespace candela::python
