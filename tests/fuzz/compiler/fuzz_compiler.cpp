// SPDX-License-Identifier: Apache-2.0
// A campaign against the Shading Language compiler alone: mutated shaders and random streams of
// words, thousands a minute. No text may crash it, hang it, take memory without bound, flood the
// terminal or make slices and code that answer otherwise than the interpreter does on the whole.
#include "inputs.h"
#include "reduce.h"
#include "trial.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>

/// Failures of the sanitizers end the process.
extern "C" const char *__asan_default_options() { return "detect_leaks=0:abort_on_error=1"; }
extern "C" const char *__ubsan_default_options() {
    return "halt_on_error=1:print_stacktrace=1:abort_on_error=1";
}

namespace candela::fuzz {
namespace {

constexpr const char *usage =
    "usage: fuzz_compiler [--first SEED] [--count N] [--jobs N] [--keep FOLDER] [--print SEED]\n"
    "       fuzz_compiler [--reduce] FILE.sl...\n"
    "Tries N mutated shaders and N streams of words; what fails is kept in the folder. Files are\n"
    "tried alone and more thoroughly; --reduce prints the least text that fails as the file does.\n"
    "Exit status: 0 nothing failed, 1 something did, 2 the arguments cannot be understood.\n";

struct Arguments {
    std::uint64_t first = 1, count = 500;
    int jobs = int(std::max(1u, std::thread::hardware_concurrency()));
    std::string keep = "fuzz-failures";
    bool reduce = false, print = false;
    std::vector<std::string> files;
};

bool parse(int count, char **words, Arguments &arguments) {
    for (int k = 1; k < count; ++k) {
        const std::string word = words[k];
        const bool takesValue = word == "--first" || word == "--count" || word == "--jobs" ||
                                word == "--keep" || word == "--print";
        if (takesValue && ++k == count)
            return false;
        if (word == "--keep")
            arguments.keep = words[k];
        else if (word == "--count")
            arguments.count = std::strtoull(words[k], nullptr, 10);
        else if (word == "--jobs")
            arguments.jobs = std::max(1, std::atoi(words[k]));
        else if (takesValue)
            arguments.first = std::strtoull(words[k], nullptr, 10);
        else if (word == "--reduce")
            arguments.reduce = true;
        else if (word.starts_with("-"))
            return false;
        else
            arguments.files.push_back(word);
        arguments.print |= word == "--print";
    }
    return true;
}

const std::string sourceFolder = CANDELA_SOURCE_DIR;
const std::string includeFolder = sourceFolder + "/shaders/surface";

Limits limits() {
    const char *scale = std::getenv("CANDELA_TIME_SCALE");
    Limits result;
    result.seconds *= scale ? std::max(1.0, std::atof(scale)) : 1;
    return result;
}

/// The kinds in turn: both have the same seeds.
InputName inputOf(std::uint64_t number) { return {InputKind(number % 2), number / 2}; }

std::string describe(const Failure &failure) {
    return std::string(nameOf(failure.stage)) +
           (failure.detail.empty() ? "" : " (" + failure.detail + ")") + ": " + failure.problem;
}

Failure tryFile(const std::string &text, Thoroughness thoroughness) {
    const TrialSettings settings{includeFolder, thoroughness};
    return tryAlone(
        [&](std::uint64_t, Monitor &monitor) { return tryText(text, settings, monitor); }, limits(),
        0);
}

bool failsAlike(const Failure &a, const Failure &b) {
    const auto kind = [](const Failure &f) { return f.problem.substr(0, f.problem.find('\n')); };
    return a.stage == b.stage && kind(a) == kind(b);
}

int tryFiles(const Arguments &arguments) {
    int failed = 0;
    for (const std::string &path : arguments.files) {
        std::ifstream file(path, std::ios::binary);
        const std::string text(std::istreambuf_iterator<char>(file), {});
        const Failure failure = tryFile(text, Thoroughness::All);
        failed += !failure.problem.empty();
        std::cerr << path << ": " << (failure.problem.empty() ? "nothing wrong" : describe(failure))
                  << "\n";
        if (failure.problem.empty() || !arguments.reduce)
            continue;
        const auto thoroughness =
            failure.stage < Stage::Generate ? Thoroughness::Interpreted : Thoroughness::All;
        std::cout << reduceText(text, [&](const std::string &shorter) {
            return failsAlike(failure, tryFile(shorter, thoroughness));
        }) << "\n";
    }
    return failed > 0;
}

/// A campaign that hardly anything of compiles would show little.
bool showsEnough(const Tally &tally, std::uint64_t count) {
    std::cout << tally.tried << " inputs; " << tally.compiled << " shaders compiled, "
              << tally.interpreted << " interpreted (" << tally.endless << " without an end), "
              << tally.compared << " compared as code\n";
    const bool enough = tally.tried == 2 * count && tally.compiled >= count / 5 &&
                        tally.compared >= count / 50 && tally.finite >= tally.numbers / 5;
    if (!enough)
        std::cout << "too few to show anything\n";
    return enough;
}

int runCampaign(const Arguments &arguments) {
    const Corpus corpus = readCorpus(
        {sourceFolder + "/shaders", sourceFolder + "/tests", sourceFolder + "/examples"});
    const TrialSettings settings{includeFolder};
    if (arguments.print) {
        const auto accepts = [&](const std::string &text) { return compiles(text, settings); };
        for (const InputKind kind : {InputKind::MutatedShader, InputKind::TokenStream})
            std::cout << makeInput({kind, arguments.first}, corpus, accepts) << "\n";
        return 0;
    }
    const Subject subject = [&](std::uint64_t number, Monitor &monitor) {
        const auto accepts = [&](const std::string &text) {
            monitor.show(text);
            return compiles(text, settings);
        };
        return tryText(makeInput(inputOf(number), corpus, accepts), settings, monitor);
    };
    int failed = 0;
    Workers workers(subject, limits(), arguments.jobs);
    workers.run(2 * arguments.first, 2 * arguments.count, [&](const Failure &failure) {
        ++failed;
        const InputName name = inputOf(failure.input);
        const auto kept = std::filesystem::path(arguments.keep) / name.file();
        std::filesystem::create_directories(arguments.keep);
        std::ofstream(kept, std::ios::binary) << failure.text;
        std::cout << kept.string() << " fails in " << describe(failure) << std::endl;
    });
    std::cout << failed << " failed of ";
    return !showsEnough(workers.tally(), arguments.count) || failed > 0;
}

int run(int count, char **words) {
    Arguments arguments;
    if (!parse(count, words, arguments)) {
        std::cerr << usage;
        return 2;
    }
    return arguments.files.empty() ? runCampaign(arguments) : tryFiles(arguments);
}

} // namespace
} // namespace candela::fuzz

int main(int count, char **words) { return candela::fuzz::run(count, words); }
