// SPDX-License-Identifier: Apache-2.0
// Solids as they are declared, and as they stand once objects are placed: an object that holds a
// solid, or is part of one, makes one of each of its placements.
#pragma once

#include "interface/ri/scene_builder.h"

#include <cstdint>
#include <map>
#include <vector>

namespace candela {

/// Where a primitive or an instance belongs.
struct SolidPlace {
    std::int32_t node = -1; ///< Whose body it bounds, or helps to; -1: none.
    bool turned = false;    ///< It is cut out: what was outside of it is inside of the solid.
};

/// A block; or what stands alone among the operands of one, a block of its own.
struct SolidBlock {
    std::int32_t group = -1; ///< That it is declared in.
    std::int32_t parent = -1;
    SolidOperation operation = SolidOperation::Primitive;
    bool subtracted = false; ///< The parent is a difference, and this is not its first operand.
};

/// All of a world and its objects, as blocks are opened and closed.
class DeclaredSolids {
public:
    static constexpr std::int32_t world = -1; ///< As a group.

    void begin(SolidOperation);
    void end() { open_.pop_back(); }
    /// Of what is told now.
    SolidPlace place();
    /// Blocks of an object are no part of those around its definition.
    void beginGroup(std::int32_t group);
    void endGroup();

    bool empty() const { return blocks_.empty(); }
    /// In the order in which they begin.
    std::vector<std::int32_t> blocksOf(std::int32_t group) const;
    const SolidBlock &block(std::int32_t number) const { return blocks_[std::size_t(number)]; }
    /// The block that has no other around it; of -1 the same.
    std::int32_t outermost(std::int32_t) const;

private:
    struct Open {
        std::int32_t block;
        bool turned;
        int operands = 0;
    };
    struct Added {
        std::int32_t block;
        bool turned;
    };
    Added add(SolidOperation);
    std::int32_t group_ = world;
    std::vector<SolidBlock> blocks_;
    std::map<std::int32_t, std::vector<std::int32_t>> byGroup_;
    std::vector<Open> open_, openAround_;
};

/// Blocks of placed objects. Parents come before their children.
struct PlacedSolids {
    struct Node {
        std::int32_t parent;
        std::int32_t block; ///< In DeclaredSolids.
        bool subtracted;
    };
    std::vector<Node> nodes;

    /// By node: it belongs to a solid that is more than one body, which nothing cuts.
    std::vector<bool> ofSeveral() const;
};

/// The blocks of the groups that are being placed within each other.
class SolidsOfGroup {
public:
    SolidsOfGroup(const DeclaredSolids &declared, PlacedSolids &placed)
        : declared_(declared), placed_(placed) {}

    /// The group is being placed for as long as it lives.
    class Visit {
    public:
        ~Visit();
        Visit(const Visit &) = delete;

    private:
        friend class SolidsOfGroup;
        explicit Visit(SolidsOfGroup &all) : all_(all) {}
        SolidsOfGroup &all_;
    };
    /// `node`: the body that the placement bounds, or helps to; -1: none.
    Visit visit(std::int32_t group, std::int32_t node);
    /// The node of a block of a group that is being placed; of -1 the innermost placement's own.
    std::int32_t nodeOf(std::int32_t block) const;

private:
    struct Group {
        std::int32_t group;
        std::int32_t node;
        std::map<std::int32_t, std::int32_t> placed; ///< By block.
    };
    const DeclaredSolids &declared_;
    PlacedSolids &placed_;
    std::vector<Group> groups_; ///< The innermost last.
};

} // namespace candela
