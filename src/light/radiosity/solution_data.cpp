// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/solution_data.h"

#include "foundation/base/raw_bytes.h"
#include "light/radiosity/solution.h"

#include <algorithm>
#include <numeric>

namespace candela::radiosity {

namespace {

template <class Data> auto fieldsOf(Data &data) {
    return std::array{&data.direct,   &data.lamps,          &data.smoothLamps, &data.emission,
                      &data.indirect, &data.smoothIndirect, &data.exitance};
}

/// Each is there when its turn comes, and has no children yet.
bool canDivide(const SolutionData &data) {
    std::vector<bool> isDivided(std::size_t(data.elements()), false);
    std::int64_t known = std::int64_t(data.roots);
    for (const std::int32_t element : data.divided) {
        if (element < 0 || element >= known || isDivided[std::size_t(element)])
            return false;
        isDivided[std::size_t(element)] = true;
        known += Basis::children;
    }
    return true;
}

bool canGather(const std::vector<NearRecord> &records, int elements) {
    const auto isKnown = [&](std::int32_t element) { return element >= 0 && element < elements; };
    return std::ranges::is_sorted(records, {}, &NearRecord::receiver) &&
           std::ranges::all_of(records, [&](const NearRecord &record) {
               return isKnown(record.receiver) && isKnown(record.sender) && isKnown(record.outline);
           });
}

bool isWhole(const SolutionData &data) {
    constexpr std::uint64_t most = 1u << 30;
    if (data.order < 1 || data.order > 3 || data.roots + 4 * data.divided.size() > most ||
        !canDivide(data))
        return false;
    const std::size_t stride = data.order <= 2 ? 4 : mostNodes;
    const auto fits = [&](const std::vector<Color> *field) {
        return field->size() == stride * std::size_t(data.elements());
    };
    const auto isFactor = [&](const std::vector<float> &factor) {
        return factor.size() == stride * std::size_t(data.elements());
    };
    return std::ranges::all_of(fieldsOf(data), fits) && isFactor(data.factorOfLamps) &&
           isFactor(data.factorOfIndirect) && canGather(data.nearLamps, data.elements()) &&
           canGather(data.nearIndirect, data.elements());
}

} // namespace

std::string bytesOf(const SolutionData &data) {
    std::string bytes;
    appendRaw(bytes, data.order);
    appendRaw(bytes, data.roots);
    appendList(bytes, data.divided);
    for (const std::vector<Color> *field : fieldsOf(data))
        appendList(bytes, *field);
    appendList(bytes, data.nearLamps);
    appendList(bytes, data.nearIndirect);
    appendList(bytes, data.factorOfLamps);
    appendList(bytes, data.factorOfIndirect);
    appendRaw(bytes, data.statistics);
    return bytes;
}

std::optional<SolutionData> solutionOf(std::string_view bytes) {
    SolutionData data;
    bool good =
        takeRaw(bytes, data.order) && takeRaw(bytes, data.roots) && takeList(bytes, data.divided);
    for (std::vector<Color> *field : fieldsOf(data))
        good = good && takeList(bytes, *field);
    good = good && takeList(bytes, data.nearLamps) && takeList(bytes, data.nearIndirect) &&
           takeList(bytes, data.factorOfLamps) && takeList(bytes, data.factorOfIndirect) &&
           takeRaw(bytes, data.statistics) && bytes.empty();
    return good && isWhole(data) ? std::optional(std::move(data)) : std::nullopt;
}

SolutionData Solution::data() const {
    SolutionData data;
    data.order = mesh_.order();
    for (int e = 0; e < mesh_.size(); ++e)
        if (mesh_.element(e).firstChild >= 0)
            data.divided.push_back(e);
    std::ranges::sort(data.divided, {}, [&](int e) { return mesh_.element(e).firstChild; });
    data.roots = std::uint64_t(mesh_.size()) - Basis::children * data.divided.size();
    data.direct = fields_.direct, data.lamps = fields_.lamps, data.emission = fields_.emission;
    data.indirect = fields_.indirect, data.exitance = fields_.exitance;
    data.smoothLamps = lamps_.smooth, data.smoothIndirect = indirect_.smooth;
    data.nearLamps = lamps_.near.records(), data.nearIndirect = indirect_.near.records();
    data.factorOfLamps = lamps_.factor, data.factorOfIndirect = indirect_.factor;
    data.statistics = statistics_;
    return data;
}

std::unique_ptr<Solution> Solution::restored(const Scene &scene, const SolutionData &data) {
    std::unique_ptr<Solution> solution(new Solution(scene, data.order));
    if (std::uint64_t(solution->mesh_.size()) != data.roots)
        return nullptr;
    solution->mesh_.subdivide(data.divided);
    Fields &fields = solution->fields_;
    fields.direct = data.direct, fields.lamps = data.lamps, fields.emission = data.emission;
    fields.indirect = data.indirect, fields.exitance = data.exitance;
    const Mesh &mesh = solution->mesh_;
    solution->lamps_ = {data.smoothLamps, NearLight(mesh, data.nearLamps, data.emission),
                        data.factorOfLamps};
    solution->indirect_ = {data.smoothIndirect, NearLight(mesh, data.nearIndirect, data.exitance),
                           data.factorOfIndirect};
    solution->statistics_ = data.statistics;
    solution->statistics_.seconds = 0;
    return solution;
}

} // namespace candela::radiosity
