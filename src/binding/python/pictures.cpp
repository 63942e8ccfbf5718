// SPDX-License-Identifier: Apache-2.0
#include "binding/python/pictures.h"

#include "binding/python/context.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace candela::python {

namespace py = pybind11;

namespace {

/// What Python holds: rows, columns, channels.
struct NumericPicture {
    py::array_t<float> pixels;
    std::vector<std::string> channels;
    std::map<std::string, std::string> metadata;
};

NumericPicture numeric(const Picture &picture) {
    const auto rows = py::ssize_t(picture.window.rows()),
               columns = py::ssize_t(picture.window.columns());
    const auto channels = py::ssize_t(picture.channels.size());
    NumericPicture result{py::array_t<float>({rows, columns, channels}), {}, picture.metadata};
    float *to = result.pixels.mutable_data();
    for (py::ssize_t i = 0; i < rows * columns; ++i)
        for (const PictureChannel &channel : picture.channels)
            *to++ = channel.values[std::size_t(i)];
    for (const PictureChannel &channel : picture.channels)
        result.channels.push_back(channel.name);
    return result;
}

std::string listOf(const std::vector<std::string> &names) {
    std::string list;
    for (const std::string &name : names)
        list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "none" : list;
}

/// "R": a plane of rows and columns; "N": all channels of that layer ("N.X", ...). Views, no
/// copies.
py::object plane(const NumericPicture &picture, const std::string &name) {
    std::vector<py::ssize_t> found;
    for (std::size_t k = 0; k < picture.channels.size(); ++k) {
        if (picture.channels[k] == name)
            return picture.pixels[py::make_tuple(py::ellipsis(), k)];
        if (picture.channels[k].starts_with(name + "."))
            found.push_back(py::ssize_t(k));
    }
    if (found.empty())
        throw py::key_error("the picture has no channel '" + name + "'; it has " +
                            listOf(picture.channels));
    return picture
        .pixels[py::make_tuple(py::ellipsis(), py::slice(found.front(), found.back() + 1, 1))];
}

NumericPicture picture(const std::optional<std::string> &name) {
    const auto &all = Context::current().pictures();
    std::vector<std::string> names;
    for (const auto &[each, picture] : all)
        names.push_back(each);
    if (name && all.contains(*name))
        return numeric(all.at(*name));
    if (!name && all.size() == 1)
        return numeric(all.begin()->second);
    throw py::key_error(name ? "there is no picture '" + *name +
                                   "'; those of displays of type \"array\" are: " + listOf(names)
                             : "picture() needs a name; displays of type \"array\" are: " +
                                   listOf(names));
}

} // namespace

void addPictures(py::module_ &module) {
    py::class_<NumericPicture>(module, "Picture",
                               "What a display of type \"array\" has got: pixels (rows x columns x "
                               "channels, float32), the names of channels, and metadata.")
        .def_readonly("pixels", &NumericPicture::pixels)
        .def_readonly("channels", &NumericPicture::channels)
        .def_readonly("metadata", &NumericPicture::metadata)
        .def("__getitem__", &plane)
        .def("__array__",
             [](const NumericPicture &picture, const py::args &type, const py::kwargs &) {
                 return type.empty() || type[0].is_none() ? py::object(picture.pixels)
                                                          : picture.pixels.attr("astype")(type[0]);
             });
    module.def("picture", &picture, py::arg("display") = py::none(),
               "picture(display=None)\n\nThe Picture of a display of type \"array\", as it has "
               "last been rendered. The name may be left out if there is one alone.");
}

} // namespace candela::python
