// SPDX-License-Identifier: Apache-2.0
#include "binding/python/requests.h"

#include "binding/python/arguments.h"
#include "binding/python/context.h"
#include "interface/ri/request_meanings.h"

#include <tuple>

namespace candela::python {

namespace {

/// Requests that make a handle: Python gets it back, and may choose it by the keyword "handle".
bool makesHandle(RequestId id) {
    return id == RequestId::LightSource || id == RequestId::AreaLightSource ||
           id == RequestId::ObjectBegin;
}

/// A request in Python: Sphere(1, -1, 1, 360, {"Cs": colors}).
class Call {
public:
    explicit Call(RequestId id) : id_(id) {}

    py::object operator()(py::args values, py::kwargs keywords) const {
        Context &context = Context::current();
        if (!context.hasBegun())
            throw py::value_error(std::string(describe(id_).name) +
                                  ": there is no context; Begin comes first");
        Arguments arguments(describe(id_), std::move(values), std::move(keywords));
        arguments.where = context.caller();
        py::object result = py::none();
        if (makesHandle(id_)) {
            result = arguments.keyword("handle");
            if (!result)
                result = py::int_(context.newHandle());
        }
        dispatch(arguments, result, context.session().requests());
        context.tell();
        return result;
    }

    std::string documentation() const {
        const RequestDescription &request = describe(id_);
        std::string text = std::string(request.name) + "(";
        for (const std::string_view name : request.argumentNames)
            if (!(name == "handle" && makesHandle(id_)))
                text += (text.ends_with('(') ? "" : ", ") +
                        std::string(name == "parameters" ? "..." : name);
        const std::string_view meaning = meaningOf(id_);
        return text + ")\n\n" +
               std::string(meaning.empty() ? "Of other renderers: it is left out, with a warning."
                                           : meaning);
    }

private:
    void dispatch(Arguments &arguments, py::handle handle, StreamSink &sink) const {
        switch (id_) {
#define CALLED(Name, handler, ...)                                                                 \
    case RequestId::Name:                                                                          \
        return perform(&StreamSink::handler, arguments, handle, sink);
#define REQUEST(...) CALLED(__VA_ARGS__)
#define REQUEST_LATER(...) CALLED(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) CALLED(__VA_ARGS__)
#define REQUEST_OF_STREAM(...) CALLED(__VA_ARGS__)
#include "interface/ri/requests.def"
#undef CALLED
        }
    }

    /// Reads the arguments of the method by their types, then calls it. Other threads of Python go
    /// on meanwhile.
    template <class Sink, class... Parameters>
    void perform(void (Sink::*method)(const SourceLocation &, Parameters...), Arguments &arguments,
                 py::handle handle, StreamSink &sink) const {
        std::tuple<std::decay_t<Parameters>...> values;
        std::apply([&](auto &...value) { (readUnlessMade(arguments, value, handle), ...); },
                   values);
        arguments.finish();
        const py::gil_scoped_release others;
        std::apply([&](const auto &...value) { (sink.*method)(arguments.where, value...); },
                   values);
    }

    template <class Value>
    void readUnlessMade(Arguments &arguments, Value &value, py::handle) const {
        readNext(arguments, value);
    }
    void readUnlessMade(Arguments &arguments, Handle &value, py::handle made) const {
        if (!makesHandle(id_))
            return readNext(arguments, value);
        arguments.setArgument(arguments.argument() + 1);
        value.text = py::str(made);
    }

    RequestId id_;
};

} // namespace

void addRequests(py::module_ &module) {
    for (int i = 0; i < int(requestTable().size()); ++i) {
        const auto id = RequestId(i);
        if (id == RequestId::version) // It belongs to RIB.
            continue;
        const Call call(id);
        module.def(std::string(describe(id).name).c_str(), call, call.documentation().c_str());
    }
}

} // namespace candela::python
