// SPDX-License-Identifier: Apache-2.0
// What Begin begins, for Python: where calls go, what is found wrong, and the pictures that come
// back. Private to the room.
#pragma once

#include "binding/session/session.h"
#include "foundation/base/diagnostics.h"
#include "image/display_taker.h"
#include "image/picture.h"
#include "render/render.h"

#include <pybind11/pybind11.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace candela::python {

/// Keeps the pictures of displays of type "array".
class Pictures final : public DisplayTaker {
public:
    Interest interestIn(const std::string &type) override {
        return type == "array" ? Interest::Instead : Interest::None;
    }
    void take(const std::string &display, Picture picture, bool) override {
        all_[display] = std::move(picture);
    }
    const std::map<std::string, Picture> &all() const { return all_; }
    void clear() { all_.clear(); }

private:
    std::map<std::string, Picture> all_;
};

class Context {
public:
    /// Where the module's calls go; they say if it has not begun.
    static Context &current();

    void begin(const std::string &name);
    void end();
    bool hasBegun() const { return session_ != nullptr; }
    Session &session() { return *session_; }

    int newHandle() { return ++handles_; }
    /// The line of Python that is being executed.
    SourceLocation caller();
    /// After a call: what has been found becomes warnings and an exception, and Ctrl-C one of its
    /// own.
    void tell();
    const std::map<std::string, Picture> &pictures() const { return pictures_.all(); }

private:
    /// Heard from all threads, told to Python when the call is over.
    class Found final : public DiagnosticSink {
    public:
        void report(const Diagnostic &) override;
        std::vector<Diagnostic> taken();

    private:
        std::mutex mutex_;
        std::vector<Diagnostic> all_;
    };

    Found found_;
    Pictures pictures_;
    std::unique_ptr<Session> session_;
    int handles_ = 0;
    bool isInterruptionTold_ = false;
    std::shared_ptr<const std::string> file_; ///< Of the last caller.
};

/// ri.Error and ri.Warning; made with the module.
extern PyObject *errorClass, *warningClass;

} // namespace candela::python
