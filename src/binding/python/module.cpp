// SPDX-License-Identifier: Apache-2.0
// candela.ri: the RenderMan Interface from Python.
#include "binding/python/context.h"
#include "binding/python/pictures.h"
#include "binding/python/requests.h"

#include <pybind11/stl.h>

namespace py = pybind11;
using namespace candela::python;

namespace {

void begin(const std::optional<std::string> &name) { Context::current().begin(name.value_or("")); }

void end() {
    Context &context = Context::current();
    if (!context.hasBegun())
        throw py::value_error("End: there is no context; Begin comes first");
    context.end();
}

void record(const std::string &type, const std::string &text) {
    Context &context = Context::current();
    if (!context.hasBegun())
        throw py::value_error("ArchiveRecord: there is no context; Begin comes first");
    context.session().record(context.caller(), type, text);
    context.tell();
}

} // namespace

PYBIND11_MODULE(ri, module) {
    module.doc() = "The RenderMan Interface by Candela. Calls have the names that they have in C, "
                   "without Ri.";
    errorClass = PyErr_NewException("candela.ri.Error", PyExc_RuntimeError, nullptr);
    warningClass = PyErr_NewException("candela.ri.Warning", PyExc_UserWarning, nullptr);
    module.attr("Error") = py::handle(errorClass);
    module.attr("Warning") = py::handle(warningClass);
    module.attr("INFINITY") = 1e38f;
    module.attr("EPSILON") = 1e-10f;

    module.def("Begin", &begin, py::arg("name") = py::none(),
               "Begin(name=None)\n\nWithout a name what follows is rendered, each world at its "
               "WorldEnd; with one it is written as RIB (\"x.rib.gz\": packed, \"|command\").");
    module.def("End", &end, "End()\n\nEnds what Begin has begun.");
    module.def(
        "ArchiveRecord", &record, py::arg("type"), py::arg("record"),
        "ArchiveRecord(type, record)\n\nA \"comment\" or \"structure\" comment of RIB that is "
        "written, or \"verbatim\" RIB.");
    addRequests(module);
    addPictures(module);
}
