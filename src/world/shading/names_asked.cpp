// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "world/shading/shader_code.h"

namespace candela {

namespace {

/// Follows a string to those that it may be. What control flow brings is left out.
class NameSearch {
public:
    explicit NameSearch(const ir::Function &function)
        : function_(function), definition_(function.values.size()) {
        ir::forEachInstruction(function.body, [&](const ir::Instruction &i) {
            for (ir::ValueId result : i.results)
                definition_[result] = &i;
        });
    }

    template <class TakeText, class TakeSlot>
    void follow(ir::ValueId string, TakeText takeText, TakeSlot takeSlot) const {
        const ir::Instruction *i = definition_[string];
        if (i && i->op == ir::Op::ConstString)
            takeText(function_.strings[std::size_t(i->immediate)]);
        if (i && i->op == ir::Op::StringFromFloat)
            if (const ir::Instruction *from = definition_[i->operands[0]];
                from && from->op == ir::Op::Parameter)
                takeSlot(from->immediate);
        if (i && i->op == ir::Op::Select)
            for (std::size_t side : {1, 2})
                follow(i->operands[side], takeText, takeSlot);
    }

private:
    const ir::Function &function_;
    std::vector<const ir::Instruction *> definition_;
};

} // namespace

std::vector<std::string> ShaderCode::namesAsked(Service service, std::int32_t offset) const {
    const ir::Function &text = shader_.whole;
    const NameSearch search(text);
    std::vector<std::string> names;
    ir::forEachInstruction(text.body, [&](const ir::Instruction &i) {
        if (!ir::isService(i.op) || serviceOf(text, i).info->service != service)
            return;
        const ir::ServiceUse &use = serviceOf(text, i);
        if (!use.hasTextAtRunTime())
            return names.push_back(text.strings[std::size_t(use.texts[0])]);
        search.follow(
            i.operands.back(), [&](const std::string &known) { names.push_back(known); },
            [&](int slot) {
                names.push_back(answers_->stringOf(int(block(offset)[std::size_t(slot)])));
            });
    });
    return names;
}

} // namespace candela
