// SPDX-License-Identifier: Apache-2.0
// What a run did, for --stats: names and numbers, written as JSON.
#pragma once

#include "foundation/base/diagnostics.h"
#include "light/frame/integrate.h"
#include "world/scene/scene.h"

#include <functional>
#include <map>
#include <string>

namespace candela {

class Statistics {
public:
    Statistics();

    /// Runs the work and adds its wall and CPU seconds under the name.
    void measure(const std::string &name, const std::function<void()> &work);
    void add(const Scene &, const TransportStatistics &);
    void add(const Jit::Statistics &);
    void write(const std::string &path, DiagnosticSink &) const;

private:
    std::map<std::string, double> numbers_;
    double wallAtStart_ = 0;
};

} // namespace candela
