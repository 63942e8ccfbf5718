// SPDX-License-Identifier: Apache-2.0
#include "binding/python/context.h"

#include <utility>

namespace candela::python {

namespace py = pybind11;

PyObject *errorClass = nullptr, *warningClass = nullptr;

void Context::Found::report(const Diagnostic &found) {
    std::lock_guard lock(mutex_);
    all_.push_back(found);
}

std::vector<Diagnostic> Context::Found::taken() {
    std::lock_guard lock(mutex_);
    return std::exchange(all_, {});
}

Context &Context::current() {
    static Context *const context = new Context; // Python's own memory may be gone at exit.
    return *context;
}

void Context::begin(const std::string &name) {
    if (session_)
        throw py::value_error("Begin: there is a Begin already; End comes first");
    RenderSettings settings;
    settings.quiet = true;
    settings.heedsSignals = true;
    settings.taker = &pictures_;
    std::string problem;
    pictures_.clear();
    handles_ = 0;
    isInterruptionTold_ = false;
    session_ = Session::begin(name, settings, found_, problem);
    if (!session_) {
        PyErr_SetString(PyExc_OSError,
                        ("Begin: '" + name + "' cannot be written: " + problem).c_str());
        throw py::error_already_set();
    }
}

void Context::end() {
    std::string problem;
    {
        const py::gil_scoped_release others;
        problem = session_->end();
    }
    session_.reset();
    if (!problem.empty())
        found_.error({}, "End: the RIB cannot be written: " + problem);
    tell();
}

SourceLocation Context::caller() {
    PyFrameObject *const frame = PyEval_GetFrame(); // Borrowed; null outside of Python's code.
    if (!frame)
        return {};
    PyCodeObject *const code = PyFrame_GetCode(frame);
    const char *name = PyUnicode_AsUTF8(code->co_filename);
    if (name && (!file_ || *file_ != name))
        file_ = std::make_shared<const std::string>(name);
    Py_DECREF(code);
    return {file_, PyFrame_GetLineNumber(frame), 0};
}

void Context::tell() {
    std::string errors;
    for (const Diagnostic &found : found_.taken()) {
        const bool here = !found.where.file || found.where.file == file_; // Python says where.
        const std::string text = (here ? "" : found.where.text() + ": ") + found.message;
        if (found.severity >= Severity::Error)
            errors += (errors.empty() ? "" : "\n") + text;
        else if (PyErr_WarnEx(warningClass, text.c_str(), 1) != 0)
            throw py::error_already_set();
    }
    if (session_ && session_->wasInterrupted() && !std::exchange(isInterruptionTold_, true))
        PyErr_SetNone(PyExc_KeyboardInterrupt);
    else if (!errors.empty())
        PyErr_SetString(errorClass, errors.c_str());
    else
        return;
    throw py::error_already_set();
}

} // namespace candela::python
