// SPDX-License-Identifier: Apache-2.0
#include "render/run_shader.h"

#include "foundation/base/whole_file.h"
#include "image/exr_file.h"
#include "image/imaging.h"
#include "image/png_file.h"
#include "render/box_grid.h"
#include "render/console.h"
#include "render/filter_words.h"
#include "render/point_grid.h"
#include "render/shader_folders.h"
#include "world/shading/shader_library.h"
#include "world/shading/shader_source.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace candela {

namespace {

/// The kind of the interface that stands for one of the language.
ShaderKind interfaceKind(sl::ShaderKind kind) {
    switch (kind) {
    case sl::ShaderKind::Light: return ShaderKind::Light;
    case sl::ShaderKind::Volume: return ShaderKind::Volume;
    case sl::ShaderKind::Displacement: return ShaderKind::Displacement;
    case sl::ShaderKind::Imager: return ShaderKind::Imager;
    case sl::ShaderKind::Transformation: return ShaderKind::Transformation;
    case sl::ShaderKind::Filter: return ShaderKind::Filter;
    default: return ShaderKind::Surface;
    }
}

/// The outputs by their names, in the order in which these occur.
std::vector<NamedPlanes> byName(const std::vector<ir::OutputSlot> &outputs, std::size_t points) {
    std::vector<NamedPlanes> all;
    for (int slot = 0; slot < int(outputs.size()); ++slot) {
        const std::string name = outputs[std::size_t(slot)].name.text();
        auto known = std::ranges::find(all, name, &NamedPlanes::name);
        if (known == all.end())
            known = all.insert(all.end(), {name, {}, {}});
        known->planes.emplace_back(points);
        known->slots.push_back(slot);
    }
    return all;
}

class ShaderRun {
public:
    explicit ShaderRun(const RunSettings &settings)
        : settings_(settings), console_(Console::Words::Messages),
          folders_(foldersOf(settings, console_)),
          shaders_({folders_.all, folders_.library, settings.jit, textureFolders(settings)},
                   console_) {}

    int status() {
        const auto instance = compile();
        if (!instance || console_.failed())
            return 1;
        if (settings_.bounds && kind_ != sl::ShaderKind::Surface) {
            console_.error({}, "--bounds: \"" + instance->code->name() +
                                   "\" is no surface shader: only these are asked over boxes");
            return 1;
        }
        const std::vector<NamedPlanes> found =
            settings_.bounds ? boundsOfBoxes(*instance, settings_.width, settings_.height)
                             : run(*instance);
        settings_.output.empty() ? print(found) : write(found);
        return console_.failed() ? 1 : 0;
    }

private:
    /// The folder of a shader that is given as a file comes first.
    static ShaderFolders foldersOf(const RunSettings &settings, DiagnosticSink &sink) {
        std::vector<std::string> path = settings.shaderPath;
        const auto folder = std::filesystem::path(settings.shader).parent_path().string();
        if (!folder.empty())
            path.insert(path.begin(), folder);
        return shaderFolders("", path, sink);
    }

    static std::vector<std::string> textureFolders(const RunSettings &settings) {
        std::vector<std::string> folders = settings.texturePath;
        folders.push_back(".");
        return folders;
    }

    std::optional<ShaderInstance> compile() {
        const std::string name =
            plainShaderName(std::filesystem::path(settings_.shader).filename().string());
        const auto kind = kindOf(name);
        if (!kind)
            return std::nullopt;
        kind_ = *kind;
        if (kind_ == sl::ShaderKind::Filter) {
            console_.error({}, "\"" + name +
                                   "\" is a filter shader: it works on a whole picture, "
                                   "not on points; candela filter IN OUT -f " +
                                   name + " runs it");
            return std::nullopt;
        }
        ShaderRecord record{name, {}, {}, {}};
        const auto types =
            shaders_.parametersOf(interfaceKind(kind_), record.name, Options(), SourceLocation());
        for (const std::string &word : settings_.values) {
            const std::string flaw = types ? takeValue(word, *types, record) : "";
            if (!flaw.empty())
                console_.error({}, "shader \"" + name + "\" " + flaw);
        }
        if (!types || console_.failed())
            return std::nullopt;
        auto instance =
            shaders_.instance(interfaceKind(kind_), record, Options(), ir::LightRule::Classic, {});
        if (instance)
            instance->code->bindSpaces({}, console_);
        return instance;
    }

    /// Of the shader of that name, or of the only one in its file.
    std::optional<sl::ShaderKind> kindOf(const std::string &name) {
        std::string problem = "no shader \"" + settings_.shader + "\" is to be found";
        for (const std::string &folder : folders_.all) {
            const std::string path = (std::filesystem::path(folder) / (name + ".sl")).string();
            std::error_code none;
            if (!std::filesystem::is_regular_file(path, none))
                continue;
            const auto text = readWholeFile(path, problem, std::size_t(1) << 26);
            if (!text)
                break;
            const auto front =
                sl::analyzeSource({path, *text}, {folders_.all, {}, false}, console_);
            for (std::size_t k = 0; front && k < front->shaders.size(); ++k)
                if (front->shaders[k]->name == name || front->shaders.size() == 1)
                    return front->shaders[k]->kind;
            problem = front ? path + " holds no shader \"" + name + "\"" : "";
            break;
        }
        if (!problem.empty())
            console_.error({}, problem);
        return std::nullopt;
    }

    std::vector<NamedPlanes> run(const ShaderInstance &instance) {
        const QuestionCode &question = instance.code->question(ir::questionsOf(kind_).front());
        const std::size_t points = std::size_t(settings_.width) * std::size_t(settings_.height);
        std::vector<NamedPlanes> found = byName(question.function.outputs, points);
        PointGrid batch(settings_.width, settings_.height, question);
        for (std::size_t first = 0; first < points; first += PointGrid::batchSize) {
            const int count = int(std::min<std::size_t>(PointGrid::batchSize, points - first));
            batch.place(kind_, first, count);
            batch.ask(question, instance, count);
            for (NamedPlanes &named : found)
                for (std::size_t c = 0; c < named.planes.size(); ++c)
                    std::copy_n(batch.output(named.slots[c]), count,
                                named.planes[c].begin() + std::ptrdiff_t(first));
        }
        return found;
    }

    static std::string inOneWord(std::string name) {
        std::ranges::replace(name, ' ', '_');
        return name;
    }

    void print(const std::vector<NamedPlanes> &found) const {
        std::string head = "# x y";
        for (const NamedPlanes &named : found)
            for (std::size_t c = 0; c < named.planes.size(); ++c)
                head += " " + inOneWord(named.name) +
                        (named.planes.size() > 1 ? "." + std::to_string(c) : "");
        std::puts(head.c_str());
        for (int y = 0; y < settings_.height; ++y)
            for (int x = 0; x < settings_.width; ++x) {
                std::printf("%d %d", x, y);
                for (const NamedPlanes &named : found)
                    for (const std::vector<float> &values : named.planes)
                        std::printf(" %.9g", double(values[std::size_t(y * settings_.width + x)]));
                std::puts("");
            }
    }

    void write(const std::vector<NamedPlanes> &found) {
        const std::string shown = !settings_.shown.empty() ? settings_.shown
                                  : settings_.bounds       ? "reflectance tolerance"
                                                           : shownOf(kind_);
        Picture picture;
        picture.window = {settings_.width, settings_.height, 0, settings_.width, 0,
                          settings_.height};
        for (const NamedPlanes &named : found)
            addChannels(named, named.name == shown, picture);
        if (!picture.find("R"))
            return console_.error({}, "the shader has no output \"" + shown + "\" to show");
        std::string problem;
        const bool isPng = std::filesystem::path(settings_.output).extension() == ".png";
        const auto bytes = isPng ? pngOf(picture, problem) : encodeExr(picture, problem);
        if (!bytes || !writeWholeFile(settings_.output, *bytes, problem))
            console_.error({}, problem);
    }

    static const char *shownOf(sl::ShaderKind kind) {
        switch (kind) {
        case sl::ShaderKind::Light: return "Cl";
        case sl::ShaderKind::Displacement:
        case sl::ShaderKind::Transformation: return "P";
        default: return "Ci";
        }
    }

    static void addChannels(const NamedPlanes &named, bool isShown, Picture &picture) {
        const std::size_t count = named.planes.size();
        for (std::size_t c = 0; c < count && c < 3; ++c) {
            const std::string letter(1, "RGB"[c]);
            const std::string layer = count == 1 ? named.name : named.name + "." + letter;
            picture.channels.push_back({isShown ? letter : layer, named.planes[c]});
        }
        for (std::size_t c = count; isShown && c < 3; ++c) // One number is grey.
            picture.channels.push_back({std::string(1, "RGB"[c]), named.planes[0]});
    }

    static std::optional<std::string> pngOf(const Picture &picture, std::string &problem) {
        Picture shown = picture;
        shown.channels.clear();
        for (const char *name : {"R", "G", "B"})
            shown.channels.push_back(*picture.find(name));
        for (PictureChannel &channel : shown.channels)
            for (float &value : channel.values)
                value = quantized(srgbCurve(value), eightBitQuantize, 0);
        return encodePng(shown, 8, std::nullopt, problem);
    }

    const RunSettings &settings_;
    Console console_;
    ShaderFolders folders_;
    ShaderLibrary shaders_;
    sl::ShaderKind kind_ = sl::ShaderKind::Surface;
};

} // namespace

int runShader(const RunSettings &settings) { return ShaderRun(settings).status(); }

} // namespace candela
