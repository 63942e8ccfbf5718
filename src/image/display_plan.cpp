// SPDX-License-Identifier: Apache-2.0
#include "image/display_plan.h"

#include "foundation/base/letters.h"
#include "foundation/base/whole_file.h"
#include "world/texture/module.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <utility>

namespace candela {

namespace {

struct KnownType {
    std::string_view type, extension;
    FileFormat format;
};
/// Depths for shadows are files of any name.
constexpr KnownType knownTypes[] = {
    {"openexr", ".exr", FileFormat::OpenExr}, {"png", ".png", FileFormat::Png},
    {"tiff", ".tif", FileFormat::Tiff},       {"tiff", ".tiff", FileFormat::Tiff},
    {"hdr", ".hdr", FileFormat::RadianceHdr}, {"zfile", "", FileFormat::OpenExr},
    {"shadow", "", FileFormat::OpenExr}};

/// What other renderers call the same.
constexpr std::pair<std::string_view, std::string_view> otherNames[] = {
    {"exr", "openexr"},    {"tif", "tiff"},           {"radiance", "hdr"},
    {"rgbe", "hdr"},       {"it", "framebuffer"},     {"x11", "framebuffer"},
    {"fb", "framebuffer"}, {"windows", "framebuffer"}};

std::string namesOfTypes() {
    std::string names = "file";
    std::string_view last;
    for (const KnownType &known : knownTypes)
        if (known.type != std::exchange(last, known.type))
            names += ", " + std::string(known.type);
    return names;
}

/// The type under the name that we have for it.
std::string typeOf(const DisplayRecord &record) {
    const std::string type = inSmallLetters(record.type);
    for (const auto &[other, own] : otherNames)
        if (type == other)
            return std::string(own);
    return type;
}

/// In small letters.
std::string extensionOf(const std::string &name) {
    return inSmallLetters(std::filesystem::path(name).extension().string());
}

/// The format by the display's type; type "file" goes by the name's extension: OpenEXR if it has
/// none, TIFF if it has one that says nothing ("env.xp"). A type that is not known becomes OpenEXR,
/// under a name that says so, and is warned about.
void chooseFormat(PlannedDisplay &display, std::string &warning) {
    DisplayRecord &record = display.record;
    const std::string extension = extensionOf(record.name);
    const std::string type = typeOf(record);
    const bool byName = type == "file";
    const auto known = byName ? std::ranges::find(knownTypes, extension, &KnownType::extension)
                              : std::ranges::find(knownTypes, type, &KnownType::type);
    if (known != std::end(knownTypes)) {
        display.format = known->format;
        return;
    }
    if (byName && extension.empty())
        return;
    if (byName) { // What "file" has always been; whoever names a file wants it under that name.
        display.format = FileFormat::Tiff;
        warning = "files are not written as \"" + extension + "\": it will be TIFF under its name";
        return;
    }
    display.standsIn = true;
    if (extension != ".exr" && !record.name.empty())
        record.name += ".exr";
    warning =
        (type == "framebuffer" ? "there is no window for the display type \"" + record.type + "\""
                               : "this version has no display type \"" + record.type +
                                     "\" (known are " + namesOfTypes() + ")") +
        ": it will be the OpenEXR file \"" + record.name + "\"";
}

/// Who asks for a file by name gets it, whoever takes the picture besides.
void chooseTaker(PlannedDisplay &display, DisplayTaker *taker, bool isRedirected) {
    using Interest = DisplayTaker::Interest;
    const Interest interest = taker ? taker->interestIn(typeOf(display.record)) : Interest::None;
    display.isTaken = interest != Interest::None;
    display.isFile = interest != Interest::Instead || isRedirected;
}

/// Of a mode that may have alpha too.
std::vector<DisplayPlane> colorPlanes(const std::vector<DisplayPlane> &planes) {
    std::vector<DisplayPlane> colors;
    std::ranges::copy_if(planes, std::back_inserter(colors), [](const DisplayPlane &plane) {
        return plane.source != DisplayPlane::Source::Alpha &&
               plane.source != DisplayPlane::Source::Depth;
    });
    return colors;
}

/// What keeps the planes out of the format; empty if nothing does.
std::string formatDefect(const PlannedDisplay &display, const Options &options) {
    if (holdsDepths(display.record) &&
        (display.planes.size() != 1 || display.planes[0].source != DisplayPlane::Source::Depth))
        return "a display of type \"" + display.record.type + "\" holds depths: its mode is \"z\"";
    if (display.format == FileFormat::RadianceHdr && colorPlanes(display.planes).size() != 3)
        return "a Radiance HDR picture holds three colors: its mode is \"rgb\"";
    std::string problem;
    if ((display.format == FileFormat::RadianceHdr || display.format == FileFormat::Tiff) &&
        !pictureLibrary(problem))
        return problem;
    if (display.format != FileFormat::Png)
        return {};
    const bool depth = std::ranges::any_of(display.planes, [](const DisplayPlane &plane) {
        return plane.source == DisplayPlane::Source::Depth;
    });
    if (depth && depthQuantize(display.record, options).one == 0)
        return "a PNG picture holds whole numbers only: give Quantize \"z\" for its depth, or use "
               "openexr";
    if (display.planes.size() > 4)
        return "a PNG picture has 1 to 4 channels, not " + std::to_string(display.planes.size()) +
               ": use openexr";
    return {};
}

/// The name with each run of '#' as the number of the frame, with at least as many digits.
std::string withFrameNumber(const std::string &name, int frame) {
    std::string result;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t end = std::min(name.find_first_not_of('#', at), name.size());
        if (end == at) {
            result += name[at++];
            continue;
        }
        std::string digits = std::to_string(std::abs(std::int64_t(frame)));
        digits.insert(0, std::max(end - at, digits.size()) - digits.size(), '0');
        result += (frame < 0 ? "-" : "") + digits;
        at = end;
    }
    return result;
}

/// The display as the user wants it in place of what the RIB says.
void redirect(DisplayRecord &record, const std::string &file) {
    record.name = file;
    record.type = "file";
}

/// Settles planes and path; false, and `problem` says why, if the display cannot be written.
/// `renamed` as tellApart() has it, `moved` as the note of outputPath().
bool settle(PlannedDisplay &display, const Options &options, std::span<const ChannelInfo> available,
            const OutputPolicy &policy, std::string &renamed, std::string &moved,
            std::string &problem) {
    auto planes = displayPlanes(display.record.mode, available, problem);
    if (!planes)
        return false;
    display.planes = std::move(*planes);
    renamed = tellApart(display.planes);
    if (!display.isFile)
        return true;
    problem = formatDefect(display, options);
    if (!problem.empty())
        return false;
    if (display.format == FileFormat::RadianceHdr)
        display.planes = colorPlanes(display.planes);
    const auto path = outputPath(display.record.name, policy.folder, moved, problem);
    if (!path || !canWriteFile(*path, problem))
        return false;
    display.path = *path;
    return true;
}

} // namespace

bool holdsDepths(const DisplayRecord &display) {
    return display.type == "zfile" || display.type == "shadow";
}

QuantizeRecord depthQuantize(const DisplayRecord &display, const Options &options) {
    if (holdsDepths(display)) // Another light's distances: always as they are.
        return {};
    return display.quantize.value_or(options.depthQuantize.value_or(QuantizeRecord{}));
}

std::vector<PlannedDisplay> planDisplays(const Options &options,
                                         std::span<const ChannelInfo> available,
                                         const OutputPolicy &policy, DiagnosticSink &sink) {
    std::vector<PlannedDisplay> plan;
    std::string file = policy.firstFile;
    for (DisplayRecord record : displaysOf(options)) {
        const SourceLocation where = record.parameters.where;
        OutputPolicy allowed = policy;
        bool isRedirected = false;
        if (!file.empty() && !holdsDepths(record)) {
            redirect(record, std::exchange(file, {}));
            allowed = {{".", true}, {}};
            isRedirected = true;
        }
        record.name = withFrameNumber(record.name, options.frame);
        const std::string about = "Display \"" + record.name + "\": ";
        PlannedDisplay display{record, {}, {}, {}, {}};
        std::string warning, renamed, moved, problem;
        chooseTaker(display, policy.taker, isRedirected);
        if (display.isFile)
            chooseFormat(display, warning);
        if (!warning.empty())
            sink.warning(where, about + warning);
        const bool settled = settle(display, options, available, allowed, renamed, moved, problem);
        if (!moved.empty())
            sink.warning(where, about + moved);
        if (!renamed.empty())
            sink.warning(where, about +
                                    "two planes of the file have one name; the second is "
                                    "written as another: " +
                                    renamed);
        if (!settled)
            sink.error(where, about + problem);
        else if (display.isFile &&
                 std::ranges::find(plan, display.path, &PlannedDisplay::path) != plan.end())
            sink.warning(where, about + "a display before it writes the same file; it is left out");
        else
            plan.push_back(std::move(display));
    }
    return plan;
}

} // namespace candela
