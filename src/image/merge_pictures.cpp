// SPDX-License-Identifier: Apache-2.0
#include "image/merge_pictures.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

namespace candela {

namespace {

std::string told(const Picture &picture, const std::string &key) {
    const auto found = picture.metadata.find(key);
    return found == picture.metadata.end() ? std::string() : found->second;
}

/// Samples a pixel, as a picture says; 0 if it does not.
double samplesOf(const Picture &picture) {
    const std::string text = told(picture, "spp");
    double samples = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), samples);
    return error == std::errc() && samples > 0 && samples < 1e15 ? samples : 0;
}

std::vector<std::string> seedsOf(const Picture &picture) {
    std::istringstream words(told(picture, "seed"));
    return {std::istream_iterator<std::string>(words), {}};
}

/// What keeps a picture from being merged with any other.
std::string flawOf(const Picture &picture) {
    if (!(samplesOf(picture) > 0) || seedsOf(picture).empty())
        return "it does not say its samples and its seed: it is no EXR picture of this renderer";
    if (told(picture, "exposure") != "1 1")
        return "it has been exposed; give Exposure 1 1";
    if (picture.metadata.contains("quantize"))
        return "it has been quantised; give Quantize \"rgba\" 0 0 0 0";
    if (picture.metadata.contains("filters"))
        return "it has been filtered; merge first, then use candela filter";
    return {};
}

/// What keeps it from being merged with the first one.
std::string differenceOf(const Picture &first, const Picture &other) {
    if (!(first.window == other.window))
        return "it shows other pixels";
    for (const char *key : {"scene", "integrator", "sampling", "maxdepth", "pixelFilter", "units"})
        if (told(first, key) != told(other, key))
            return fmt::format("its {} is \"{}\", and not \"{}\"", key, told(other, key),
                               told(first, key));
    const auto namesOf = [](const Picture &picture) {
        std::set<std::string> names;
        for (const PictureChannel &channel : picture.channels)
            names.insert(channel.name);
        return names;
    };
    if (namesOf(first) != namesOf(other))
        return "it has other channels";
    if (first.worldToCamera != other.worldToCamera || first.worldToNdc != other.worldToNdc)
        return "its camera is another";
    return {};
}

bool canMerge(const std::vector<NamedPicture> &pictures, std::string &problem) {
    const NamedPicture &first = pictures.front();
    std::map<std::string, std::string> ownerOfSeed;
    for (const auto &[name, picture] : pictures) {
        std::string flaw = flawOf(picture);
        if (flaw.empty())
            flaw = differenceOf(first.picture, picture);
        for (const std::string &seed : seedsOf(picture))
            if (const auto [owner, isNew] = ownerOfSeed.try_emplace(seed, name);
                !isNew && flaw.empty())
                flaw = fmt::format("it is of seed {}, as {} is: it holds the same samples", seed,
                                   owner->second);
        if (flaw.empty())
            continue;
        problem = name + " cannot be merged" +
                  (&picture == &first.picture ? ": " : " with " + first.name + ": ") + flaw;
        return false;
    }
    return true;
}

enum class Rule { Mean, Variance, Nearest, First };

Rule ruleOf(const std::string &channel) {
    return channel == "Z"                    ? Rule::Nearest
           : channel == "id"                 ? Rule::First
           : channel.starts_with("variance") ? Rule::Variance
                                             : Rule::Mean;
}

/// `weights` are the pictures' shares of all samples.
std::vector<float> merged(const std::string &channel, const std::vector<NamedPicture> &pictures,
                          const std::vector<double> &weights) {
    const Rule rule = ruleOf(channel);
    std::vector<float> result = pictures[0].picture.find(channel)->values;
    if (rule == Rule::First)
        return result;
    std::vector<const float *> values;
    for (const NamedPicture &named : pictures)
        values.push_back(named.picture.find(channel)->values.data());
    for (std::size_t i = 0; i < result.size(); ++i) {
        double sum = 0;
        for (std::size_t k = 0; k < values.size(); ++k) {
            const double value = values[k][i];
            if (rule == Rule::Nearest)
                result[i] = std::min(result[i], values[k][i]);
            else
                sum +=
                    rule == Rule::Variance ? weights[k] * weights[k] * value : weights[k] * value;
        }
        if (rule != Rule::Nearest)
            result[i] = float(sum);
    }
    return result;
}

} // namespace

std::optional<Picture> mergePictures(const std::vector<NamedPicture> &pictures,
                                     std::string &problem) {
    if (!canMerge(pictures, problem))
        return std::nullopt;
    double samples = 0;
    std::string seeds;
    for (const auto &[name, picture] : pictures) {
        samples += samplesOf(picture);
        seeds += (seeds.empty() ? "" : " ") + told(picture, "seed");
    }
    std::vector<double> weights;
    for (const auto &[name, picture] : pictures)
        weights.push_back(samplesOf(picture) / samples);
    Picture result = pictures[0].picture;
    for (PictureChannel &channel : result.channels)
        channel.values = merged(channel.name, pictures, weights);
    result.metadata["spp"] = fmt::format("{:.12g}", samples);
    result.metadata["seed"] = seeds;
    result.metadata.erase("sppRange");
    return result;
}

} // namespace candela
