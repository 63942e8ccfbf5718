// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_images.h"

#include <algorithm>

namespace candela::ir {

/// The number of the use, which the function gets if it has it not.
static int internUse(Function &function, const std::string &map, int values,
                     runtime::ImageFilter filter) {
    const ImageUse use{intern(function.maps, map), values, filter};
    const auto found = std::find(function.images.begin(), function.images.end(), use);
    const int index = int(found - function.images.begin());
    if (found == function.images.end())
        function.images.push_back(use);
    return index;
}

Values imageLoad(Builder &b, const std::string &map, int values, runtime::ImageFilter filter,
                 const LookupOperands &operands) {
    return b.emit(Op::ImageLoad, {operands.begin(), operands.end()},
                  internUse(b.function(), map, values, filter));
}

void imageStore(Builder &b, const std::string &map, ValueId x, ValueId y, const Values &value) {
    Values operands{x, y};
    operands.insert(operands.end(), value.begin(), value.end());
    b.emit(Op::ImageStore, operands,
           internUse(b.function(), map, int(value.size()), runtime::ImageFilter::Nearest));
}

} // namespace candela::ir
