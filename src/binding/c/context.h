// SPDX-License-Identifier: Apache-2.0
// What RiBegin begins: where calls go (a renderer, or RIB that is written), and what they need to
// know of the calls before. Private to the room.
#pragma once

#include "binding/session/session.h"
#include "interface/ri/declarations.h"
#include "interface/ri/variable_counts.h"
#include "ri.h"

#include <memory>
#include <string>
#include <vector>

namespace candela::c {

/// A parameter list in the form that ends in V.
struct Parameters {
    RtInt count;
    const RtToken *tokens;
    const RtPointer *values;
};

class Context {
public:
    Context();
    ~Context();
    /// As RiBegin is told. False, and reported, if there is no such context.
    bool begin(const char *name);
    /// RiEnd.
    void end();

    Session &session() { return *session_; }
    StreamSink &sink() { return session_->requests(); }
    DiagnosticSink &diagnostics() { return session_->diagnostics(); }

    /// Counts calls: messages tell which one it was, and its name.
    void beginCall(const char *name);
    SourceLocation at() const { return where_; }
    void error(const std::string &message);

    void declare(const std::string &name, const std::string &declaration);
    /// The parameters, their numbers of values as the primitive has them; `category` is that of an
    /// Option or Attribute. What is not declared is reported and left out.
    TokenList list(const VariableCounts &, const Parameters &, const std::string &category = {});
    /// For a light or object of that name, or of one that no other has.
    RtPointer newHandle(RtToken name = RI_NULL);
    Handle nameOf(RtPointer handle) const;

    // The steps of the bases are attributes: they say how many values meshes and curves have.
    void openBlock() { steps_.push_back(steps_.back()); }
    void closeBlock();
    void setSteps(int u, int v) { steps_.back() = {u, v}; }
    VariableCounts meshCounts(const std::string &type, int uVertices, const std::string &uWrap,
                              int vVertices, const std::string &vWrap) const;
    VariableCounts curveCounts(const std::string &type, int curves, const int *vertexCounts,
                               const std::string &wrap) const;

private:
    struct Steps {
        int u = 3, v = 3;
    };
    const std::unique_ptr<DiagnosticSink> found_; ///< The program's handler hears of it.
    std::unique_ptr<Session> session_;
    Dictionary dictionary_;
    std::vector<Steps> steps_{1};
    SourceLocation where_;
    std::string call_;
    std::vector<std::string> handles_; ///< What the pointers 1, 2... stand for.
};

} // namespace candela::c
