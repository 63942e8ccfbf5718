// SPDX-License-Identifier: Apache-2.0
// Where a filter's text looks up and sets maps.
#pragma once

#include "language/ir/core/regions.h"

namespace candela {

/// An ImageLoad or an ImageStore.
struct MapAccess {
    const ir::Instruction &instruction;
    const ir::ImageUse &use;
    bool isSerial; ///< Not in a pixel loop.
};

/// Visits all of the filter, those of its pixel loops last.
template <typename Visit> void forEachImageUse(const ir::Function &driver, Visit visit) {
    const auto visitAll = [&](const ir::Function &function, bool isSerial) {
        ir::forEachInstruction(function.body, [&](const ir::Instruction &i) {
            if (i.op == ir::Op::ImageLoad || i.op == ir::Op::ImageStore)
                visit(MapAccess{i, function.images[std::size_t(i.immediate)], isSerial});
        });
    };
    visitAll(driver, true);
    for (const ir::PixelLoop &loop : driver.pixelLoops)
        visitAll(*loop.body, false);
}

} // namespace candela
