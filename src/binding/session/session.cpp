// SPDX-License-Identifier: Apache-2.0
#include "binding/session/session.h"

#include "image/view/picture_window.h"
#include "interface/rib/rib_stream.h"
#include "interface/rib/rib_writer.h"
#include "render/render_session.h"

#include <algorithm>
#include <utility>

namespace candela {

namespace {

class Rendering final : public Session {
public:
    Rendering(RenderSettings settings, DiagnosticSink &found)
        : session_("ri", withTaker(settings), found) {}
    StreamSink &requests() override { return session_.requests(); }
    DiagnosticSink &diagnostics() override { return session_.diagnostics(); }
    std::string end() override {
        session_.finish();
        if (wasInterrupted())
            window_.close();
        return {};
    }
    bool wasInterrupted() const override { return session_.end() == FrameEnd::Interrupted; }

private:
    const RenderSettings &withTaker(RenderSettings &settings) {
        if (!settings.taker)
            settings.taker = &window_;
        return settings;
    }

    PictureWindow window_{PictureWindow::Purpose::Framebuffers}; ///< If nobody else takes pictures.
    RenderSession session_;
};

class Writing final : public Session {
public:
    Writing(std::unique_ptr<ByteOutput> output, DiagnosticSink &found)
        : found_(found), output_(std::move(output)), writer_(*output_, RibEncoding::Ascii) {
        writer_.comment({}, "#RenderMan RIB");
    }
    StreamSink &requests() override { return writer_; }
    DiagnosticSink &diagnostics() override { return found_; }
    std::string end() override {
        writer_.flush();
        return output_->close();
    }

private:
    DiagnosticSink &found_;
    std::unique_ptr<ByteOutput> output_;
    RibWriter writer_;
};

} // namespace

bool Session::record(const SourceLocation &where, const std::string &type, std::string text) {
    if (type == "verbatim") {
        readRibText(std::move(text), "ArchiveRecord", requests(), diagnostics());
        return true;
    }
    if (type != "comment" && type != "structure") {
        diagnostics().error(where, "ArchiveRecord: '" + type +
                                       "' is unknown: expected \"comment\", \"structure\" or "
                                       "\"verbatim\"");
        return false;
    }
    std::replace(text.begin(), text.end(), '\n', ' '); // It is one line.
    requests().comment(where, (type == "structure" ? "#" : " ") + text);
    return true;
}

std::unique_ptr<Session> Session::begin(const std::string &name, const RenderSettings &settings,
                                        DiagnosticSink &found, std::string &problem) {
    if (name.empty())
        return std::make_unique<Rendering>(settings, found);
    const auto packing =
        name.ends_with(".gz") ? ByteOutput::Packing::Gzip : ByteOutput::Packing::Plain;
    auto output = name.starts_with('|') ? ByteOutput::toCommand(name.substr(1), problem)
                                        : ByteOutput::open(name, packing, problem);
    return output ? std::make_unique<Writing>(std::move(output), found) : nullptr;
}

} // namespace candela
