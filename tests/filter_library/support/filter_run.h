// SPDX-License-Identifier: Apache-2.0
// Runs filters of the library, and others, over pictures in memory.
#pragma once

#include "image/filter/image_maps.h"
#include "interface/ri/attributes.h"
#include "language/runtime/isa_level.h"
#include "tests/filter_library/support/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace candela::filters {

/// A filter with its parameters, as PushFilter names them; what is given again replaces.
class Filter {
public:
    explicit Filter(std::string name) : name_(std::move(name)) {}

    Filter with(const std::string &name, double value) const { return withAll(name, {value}); }
    Filter with(const std::string &name, const std::string &value) const;
    /// An array.
    Filter withAll(const std::string &name, const std::vector<double> &values) const;

    ShaderRecord record() const;

private:
    Filter with(Parameter) const;

    std::string name_;
    std::vector<Parameter> parameters_;
};

/// How code is made and run. No result may depend on it.
struct Ways {
    int lanes = 16;
    int threads = 0; ///< 0: as many as there are
    std::optional<runtime::IsaLevel> level;
};

/// Maps with a picture as Ci, all of it opaque.
ImageMaps mapsOf(const Picture &);
/// A map of three channels.
void setMap(ImageMaps &, const std::string &name, const Picture &);
/// What a map holds: three channels, or the first one three times.
Picture pictureOf(const ImageMaps &, const std::string &name = "Ci");

/// Runs them in order; what they say goes to `messages`, or else fails the test.
void run(const std::vector<Filter> &, ImageMaps &, const Ways &ways = {},
         std::string *messages = nullptr);
/// The picture that one filter makes.
Picture filtered(const Filter &, const Picture &, const Ways &ways = {});

} // namespace candela::filters
