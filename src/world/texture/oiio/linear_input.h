// SPDX-License-Identifier: Apache-2.0
// A file as linear light: what is averaged to smaller levels, and between pixels, has to be light.
#pragma once

#include "world/texture/oiio/color_curve.h"

#include <memory>

namespace candela {

/// Reads the file behind the name of linearName(), of whatever format, as half floats.
class LinearInput final : public OIIO::ImageInput {
public:
    const char *format_name() const override { return "candela_linear"; }
    bool open(const std::string &name, OIIO::ImageSpec &) override;
    bool open(const std::string &name, OIIO::ImageSpec &spec, const OIIO::ImageSpec &) override {
        return open(name, spec);
    }
    bool close() override;
    int current_subimage() const override { return file_ ? file_->current_subimage() : 0; }
    int current_miplevel() const override { return file_ ? file_->current_miplevel() : 0; }
    bool seek_subimage(int subimage, int miplevel) override;
    bool read_native_scanline(int subimage, int miplevel, int y, int z, void *) override;
    bool read_native_tile(int subimage, int miplevel, int x, int y, int z, void *) override;

private:
    void describe();
    /// What has been read of the file, as light and half floats.
    bool deliver(bool good, std::vector<float> &, void *);

    std::unique_ptr<OIIO::ImageInput> file_;
    ColorCurve curve_;
};

/// The name under which a file is opened by a LinearInput.
std::string linearName(const std::string &path);

/// Opens a file, alpha left as it stands there.
std::unique_ptr<OIIO::ImageInput> openPicture(const std::string &path, std::string &problem);

} // namespace candela
