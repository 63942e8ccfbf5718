// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/outputs.h"

#include <gtest/gtest.h>

namespace candela::ir {
namespace {

TEST(OutputName, IsReadAsItIsSpelled) {
    for (int kind = 0; kind < int(OutputKind::Parameter); ++kind)
        for (int cone : {0, 12}) {
            const bool ofCone = OutputKind(kind) >= OutputKind::ConeAxis;
            const OutputName name(OutputKind(kind), ofCone ? cone : 0);
            EXPECT_EQ(OutputName(name.text()), name) << name.text();
            EXPECT_EQ(name.text().starts_with("cone "), ofCone) << name.text();
        }
}

TEST(OutputName, OfAShadersOwnIsItsText) {
    for (const char *text :
         {"result", "DCiDu", "cone", "cone 0", "cone x axis", "axis", "cone 1 Ci"}) {
        const OutputName name(text);
        EXPECT_EQ(name.kind, OutputKind::Parameter) << text;
        EXPECT_EQ(name.text(), text);
    }
}

TEST(OutputName, OfAParameterIsNoRowOfThatName) {
    for (const char *text : {"g", "L", "Cl", "dPdu", "completed", "cone 0 axis", "weight"}) {
        const OutputName name = OutputName::ofParameter(text);
        EXPECT_EQ(name.kind, OutputKind::Parameter) << text;
        EXPECT_EQ(name.text(), text);
    }
    EXPECT_EQ(slotOf({{OutputKind::G, 0}}, OutputName::ofParameter("g")), -1);
}

TEST(OutputName, FindsItsSlot) {
    const std::vector<OutputSlot> slots = {
        {OutputKind::Ci, 0}, {OutputKind::Ci, 1}, {{OutputKind::ConeAngle, 1}, 0}};
    EXPECT_EQ(slotOf(slots, OutputKind::Ci, 1), 1);
    EXPECT_EQ(slotOf(slots, {OutputKind::ConeAngle, 1}), 2);
    EXPECT_EQ(slotOf(slots, {OutputKind::ConeAngle, 0}), -1);
    EXPECT_EQ(slotOf(slots, OutputKind::Oi), -1);
}

} // namespace
} // namespace candela::ir
