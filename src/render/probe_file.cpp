// SPDX-License-Identifier: Apache-2.0
#include "render/probe_file.h"

#include "foundation/base/parallel.h"
#include "foundation/base/whole_file.h"
#include "render/false_colors.h"
#include "render/frame_settings.h"
#include "render/picture_output.h"
#include "render/probe_points.h"
#include "render/read_scenes.h"
#include "render/solution_keeping.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <new>
#include <unistd.h>

namespace candela {

namespace {

/// The points' file, open.
class PointsFile {
public:
    explicit PointsFile(const std::string &path)
        : file_(path == "-" ? dup(STDIN_FILENO) : open(path.c_str(), O_RDONLY | O_CLOEXEC)),
          error_(errno) {}
    ~PointsFile() {
        if (file_ >= 0)
            close(file_);
    }
    PointsFile(const PointsFile &) = delete;
    int file() const { return file_; }
    std::string problem() const { return file_ < 0 ? std::strerror(error_) : ""; }

private:
    int file_, error_;
};

/// Everything behind the scene: one world, its points and their answers.
class ProbeRun {
public:
    ProbeRun(const ProbeFileSettings &settings, const FrameListeners &listeners)
        : settings_(settings), listeners_(listeners),
          name_(std::make_shared<const std::string>(settings.points == "-" ? "standard input"
                                                                           : settings.points)) {}

    void probe(const Scene &scene, ShaderLibrary &shaders, const std::string &world) {
        ProbeSettings probe = settings_.probe;
        probe.integrator = integratorSettings(scene, settings_.render);
        const FrameIdentity identity =
            solutionIdentity(scene, settings_.render, world, shaders.fingerprint());
        if (!keepSolution(scene, settings_.render, identity, probe.integrator,
                          listeners_.diagnostics))
            return;
        TransportStatistics transport;
        Prober prober(scene, probe, transport, listeners_.diagnostics);
        listeners_.console.begin("probing");
        listeners_.statistics.measure("probe", [&] {
            if (settings_.plane)
                answerPlane(prober, *settings_.plane, scene, shaders);
            else
                answerLines(prober);
        });
        listeners_.statistics.add(scene, transport);
        if (unreached_ > 0)
            listeners_.diagnostics.warning(
                {}, fmt::format("{} of {} points did not come within {:g} % in {} samples; --spp "
                                "allows more",
                                unreached_, answered_, 100 * *settings_.probe.accuracy,
                                settings_.probe.samples));
        listeners_.console.end(fmt::format("probed {} points", answered_));
    }

private:
    /// A line of the file in the order of their coming: a point, or none.
    struct Row {
        int point = -1;
    };

    // ---- Lines ----

    void answerLines(Prober &prober) {
        const PointsFile file(settings_.points);
        if (file.file() < 0)
            return error(0, file.problem());
        LineReader lines(file.file());
        AnswerStream stream;
        bool goesOn = stream.write(answerHeader(settings_.format, settings_.probe.quantity));
        const std::size_t most = std::size_t(Prober::blockSize) * 16 * std::size_t(threadCount());
        while (goesOn && collect(lines, most)) {
            answerCollected(prober);
            goesOn = stream.write(textOfRows());
            listeners_.console.step(fmt::format("probing: {} points", answered_), -1);
        }
        if (!lines.problem().empty())
            error(lines.number(), lines.problem());
        if (!stream.problem().empty())
            listeners_.diagnostics.error(
                {}, fmt::format("the answers cannot be written to standard output: {}; further "
                                "points are not looked at",
                                stream.problem()));
        else if (answered_ + flawed_ == 0 && lines.problem().empty())
            error(0, "holds no points: write one a line, x y z and the direction dx dy dz");
    }

    /// Up to `most` points and the rows that they stand in; false if there are no more.
    bool collect(LineReader &lines, std::size_t most) {
        rows_.clear(), points_.clear();
        while (points_.size() < most) {
            const auto line = lines.next();
            if (!line)
                break;
            PointLine read = readPointLine(*line, lines.number());
            if (read.kind == PointLine::Kind::Nothing)
                continue;
            if (read.kind == PointLine::Kind::Point) {
                rows_.push_back({int(points_.size())});
                points_.push_back(read.point);
                continue;
            }
            rows_.push_back({});
            ++flawed_;
            listeners_.diagnostics.report({Severity::Error,
                                           {name_, lines.number(), read.column},
                                           read.flaw,
                                           std::string(*line)});
        }
        return !rows_.empty();
    }

    std::string textOfRows() const {
        std::string text;
        for (const Row &row : rows_)
            text += row.point < 0 ? missingAnswer(settings_.format)
                                  : answerLine(settings_.format, points_[std::size_t(row.point)],
                                               answers_[std::size_t(row.point)]);
        return text;
    }

    void answerCollected(Prober &prober) {
        answers_.assign(points_.size(), {});
        prober.answer(points_, answers_);
        answered_ += points_.size();
        for (std::size_t k = 0; k < points_.size(); ++k) {
            unreached_ += !answers_[k].reached;
            if (answers_[k].enclosed)
                error(settings_.plane ? 0 : points_[k].number, enclosedMessage(points_[k]));
        }
    }

    static std::string enclosedMessage(const ProbePoint &point) {
        return fmt::format("no light comes to ({:g}, {:g}, {:g}) from any side: it lies within "
                           "something opaque; move it into the open, or, if it lies on a surface, "
                           "a little off it (--offset)",
                           point.P[0], point.P[1], point.P[2]);
    }

    // ---- Planes ----

    void answerPlane(Prober &prober, const WorkPlane &plane, const Scene &scene,
                     ShaderLibrary &shaders) {
        const std::vector<ProbePoint> all = plane.points();
        std::vector<ProbeAnswer> answers;
        const std::size_t most = std::size_t(Prober::blockSize) * 4 * std::size_t(threadCount());
        for (std::size_t first = 0; first < all.size(); first += most) {
            const auto from = all.begin() + std::ptrdiff_t(first);
            points_.assign(from, from + std::ptrdiff_t(std::min(most, all.size() - first)));
            answerCollected(prober);
            answers.insert(answers.end(), answers_.begin(), answers_.end());
            listeners_.console.progress(double(answers.size()) / double(all.size()));
        }
        if (!settings_.output.empty())
            return writePlane(plane, answers, scene, shaders);
        AnswerStream stream;
        std::string text = answerHeader(settings_.format, settings_.probe.quantity);
        if (settings_.format == AnswerFormat::Csv)
            for (std::size_t k = 0; k < all.size(); ++k)
                text += answerLine(settings_.format, all[k], answers[k]);
        else
            text += tableOf(plane, settings_.probe.quantity, answers);
        if (!stream.write(text))
            listeners_.diagnostics.error({}, "the table cannot be written to standard output: " +
                                                 stream.problem());
    }

    void writePlane(const WorkPlane &plane, const std::vector<ProbeAnswer> &answers,
                    const Scene &scene, ShaderLibrary &shaders) {
        Picture picture = pictureOf(plane, settings_.probe.quantity, answers);
        std::string problem;
        if (isPngName(settings_.output)) {
            picture = enlarged(plane, picture);
            if (!showInFalseColors(picture, settings_.probe.quantity, settings_.falsecolor, shaders,
                                   scene.options(), listeners_))
                return;
        }
        if (!writePicture(picture, settings_.output, std::nullopt, problem))
            listeners_.diagnostics.error({}, problem);
    }

    void error(int line, const std::string &text) {
        listeners_.diagnostics.error({name_, line}, text);
    }

    const ProbeFileSettings &settings_;
    const FrameListeners &listeners_;
    const std::shared_ptr<const std::string> name_; ///< Of the points' file.
    std::vector<Row> rows_;
    std::vector<ProbePoint> points_;
    std::vector<ProbeAnswer> answers_;
    std::size_t answered_ = 0, flawed_ = 0, unreached_ = 0;
};

} // namespace

int probeFile(const ProbeFileSettings &settings) {
    std::signal(SIGPIPE, SIG_IGN); // Writing just fails, and says why.
    const RenderSettings &render = settings.render;
    Console console(render.quiet ? Console::Words::Messages : Console::Words::Progress);
    ErrorPolicy diagnostics(console);
    ThreadLimit threads(render.threads);
    Statistics statistics;
    const FrameListeners listeners{diagnostics, console, statistics};
    std::string problem;
    if (!settings.output.empty() && !canWriteFile(settings.output, problem)) {
        diagnostics.error({}, problem);
        return 1;
    }
    int worlds = 0;
    readScenes(
        {settings.scene}, render, listeners,
        [&](const Scene &scene, ShaderLibrary &shaders, const SceneFingerprints &fingerprints) {
            if (worlds++ > 0)
                return;
            try {
                ProbeRun(settings, listeners).probe(scene, shaders, fingerprints.world);
            } catch (const std::bad_alloc &) {
                diagnostics.error({}, "there is not enough memory to probe this scene");
            }
        });
    if (worlds > 1)
        diagnostics.warning(
            {std::make_shared<const std::string>(settings.scene)},
            fmt::format("there are {} worlds in it: the first one has been probed", worlds));
    if (!render.statisticsFile.empty())
        statistics.write(render.statisticsFile, diagnostics);
    return console.failed() ? 1 : 0;
}

} // namespace candela
