// SPDX-License-Identifier: Apache-2.0
#include "world/scene/declared_solids.h"

#include <algorithm>
#include <utility>

namespace candela {

DeclaredSolids::Added DeclaredSolids::add(SolidOperation operation) {
    SolidBlock block{group_, -1, operation, false};
    bool turned = false;
    if (!open_.empty()) {
        Open &around = open_.back();
        block.parent = around.block;
        const bool isDifference =
            blocks_[std::size_t(around.block)].operation == SolidOperation::Difference;
        block.subtracted = isDifference && around.operands > 0;
        turned = around.turned != block.subtracted;
        ++around.operands;
    }
    byGroup_[group_].push_back(std::int32_t(blocks_.size()));
    blocks_.push_back(block);
    return {std::int32_t(blocks_.size()) - 1, turned};
}

void DeclaredSolids::begin(SolidOperation operation) {
    const auto [block, turned] = add(operation);
    open_.push_back({block, turned});
}

SolidPlace DeclaredSolids::place() {
    if (open_.empty())
        return {};
    const Open &around = open_.back();
    if (blocks_[std::size_t(around.block)].operation == SolidOperation::Primitive)
        return {around.block, around.turned};
    const auto [block, turned] = add(SolidOperation::Primitive);
    return {block, turned};
}

void DeclaredSolids::beginGroup(std::int32_t group) {
    group_ = group;
    openAround_ = std::exchange(open_, {});
}

void DeclaredSolids::endGroup() {
    group_ = world;
    open_ = std::exchange(openAround_, {});
}

std::vector<std::int32_t> DeclaredSolids::blocksOf(std::int32_t group) const {
    const auto found = byGroup_.find(group);
    return found == byGroup_.end() ? std::vector<std::int32_t>{} : found->second;
}

std::int32_t DeclaredSolids::outermost(std::int32_t number) const {
    while (number >= 0 && block(number).parent >= 0)
        number = block(number).parent;
    return number;
}

SolidsOfGroup::Visit::~Visit() {
    if (!all_.declared_.empty())
        all_.groups_.pop_back();
}

SolidsOfGroup::Visit SolidsOfGroup::visit(std::int32_t group, std::int32_t node) {
    if (!declared_.empty()) {
        groups_.push_back({group, node, {}});
        std::map<std::int32_t, std::int32_t> &placed = groups_.back().placed;
        for (std::int32_t number : declared_.blocksOf(group)) {
            const SolidBlock &block = declared_.block(number);
            placed_.nodes.push_back(
                {block.parent >= 0 ? placed.at(block.parent) : node, number, block.subtracted});
            placed[number] = std::int32_t(placed_.nodes.size()) - 1;
        }
    }
    return Visit(*this);
}

std::int32_t SolidsOfGroup::nodeOf(std::int32_t block) const {
    if (declared_.empty())
        return -1;
    if (block < 0)
        return groups_.back().node;
    // No group is in itself.
    return std::ranges::find(groups_.rbegin(), groups_.rend(), declared_.block(block).group,
                             &Group::group)
        ->placed.at(block);
}

std::vector<bool> PlacedSolids::ofSeveral() const {
    std::vector<bool> several(nodes.size());
    std::vector<std::size_t> outermost(nodes.size());
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        outermost[k] = nodes[k].parent < 0 ? k : outermost[std::size_t(nodes[k].parent)];
        several[outermost[k]] = several[outermost[k]] || outermost[k] != k;
    }
    for (std::size_t k = 0; k < nodes.size(); ++k)
        several[k] = several[outermost[k]];
    return several;
}

} // namespace candela
