// SPDX-License-Identifier: Apache-2.0
#include "language/jit/function_hash.h"

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"

#include <bit>

namespace candela {

static void addIds(ContentHash &hash, const std::vector<ir::ValueId> &ids) {
    hash.add(ids.size());
    for (ir::ValueId id : ids)
        hash.add(std::uint64_t(id));
}

static void addTexts(ContentHash &hash, const std::vector<std::string> &texts) {
    hash.add(texts.size());
    for (const std::string &text : texts) {
        hash.add(text.size());
        hash.add(text);
    }
}

/// What speaks of its place in the source at run time.
static bool namesPlace(const ir::Instruction &i) {
    return ir::isArrayAccess(i.op) || ir::isService(i.op) || i.op == ir::Op::Loop;
}

static void addRegion(ContentHash &hash, const ir::Region &region) {
    addIds(hash, region.arguments);
    addIds(hash, region.yields);
    hash.add(region.body.size());
    for (const ir::Instruction &i : region.body) {
        hash.add(std::uint64_t(i.op));
        hash.add(std::uint64_t(std::uint32_t(i.immediate)));
        hash.add(std::uint64_t(std::bit_cast<std::uint32_t>(i.number)));
        if (namesPlace(i)) {
            hash.add(std::uint64_t(std::uint32_t(i.line)));
            hash.add(std::uint64_t(std::uint32_t(i.file)));
        }
        addIds(hash, i.operands);
        addIds(hash, i.results);
        hash.add(i.regions.size());
        for (const ir::Region &inner : i.regions)
            addRegion(hash, inner);
    }
}

void addFunction(ContentHash &hash, const ir::Function &function) {
    hash.add(std::uint64_t(function.colors.samples));
    hash.add(function.values.size());
    for (const ir::Value &value : function.values)
        hash.add(std::uint64_t(value.type) << 8 | std::uint64_t(value.uniformity));
    hash.add(function.arrays.size());
    for (const ir::Array &array : function.arrays) {
        hash.add(std::uint64_t(array.type) << 8 | std::uint64_t(array.uniformity));
        hash.add(std::uint64_t(array.size));
        hash.add(std::uint64_t(std::int64_t(array.captured)));
    }
    hash.add(function.images.size());
    for (const ir::ImageUse &use : function.images) {
        hash.add(std::uint64_t(std::uint32_t(use.map)) << 32 |
                 std::uint64_t(std::uint32_t(use.values)));
        hash.add(std::uint64_t(use.filter));
    }
    hash.add(function.pixelLoops.size());
    for (const ir::PixelLoop &loop : function.pixelLoops) {
        hash.add(loop.arrays.size());
        for (int array : loop.arrays)
            hash.add(std::uint64_t(std::uint32_t(array)));
    }
    hash.add(function.requests.size());
    for (const ir::LightRequest &request : function.requests) {
        hash.add(std::uint64_t(request.kind) << 8 | std::uint64_t(request.form));
        hash.add(std::uint64_t(std::uint32_t(request.coneCount)));
        hash.add(std::uint64_t(std::uint32_t(request.category)));
    }
    hash.add(function.services.size());
    for (const ir::ServiceUse &use : function.services) {
        hash.add(std::string_view(use.info->name));
        hash.add(std::uint64_t(use.info->service));
        hash.add(std::uint64_t(std::uint32_t(use.results)));
        hash.add(use.texts.size());
        for (int text : use.texts)
            hash.add(std::uint64_t(std::uint32_t(text)));
    }
    addTexts(hash, function.strings);
    addTexts(hash, ir::anyInstruction(function.body, namesPlace) ? function.files
                                                                 : std::vector<std::string>());
    hash.add(std::uint64_t(function.lanes));
    hash.add(std::uint64_t(std::uint32_t(function.surfaceSlots)) << 32 |
             std::uint64_t(std::uint32_t(function.viewSlots)));
    hash.add(std::uint64_t(std::uint32_t(function.mostTurns)) << 1 |
             std::uint64_t(function.isEndless));
    hash.add(std::uint64_t(std::uint32_t(function.registersTogether)) << 1 |
             std::uint64_t(function.isFused));
    for (const ir::OutputSlot &slot : function.outputs)
        hash.add(std::uint64_t(std::bit_cast<std::uint32_t>(slot.whenEnded)));
    addRegion(hash, function.body);
}

} // namespace candela
