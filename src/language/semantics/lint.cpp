// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/lint.h"

#include <algorithm>
#include <cmath>

namespace candela::sl {

static bool mentionsPi(const ast::Expr &e) {
    // Macros for PI leave a number behind.
    bool itself = e.kind == ast::ExprKind::Name && e.text == "PI";
    bool number = e.kind == ast::ExprKind::Number && std::abs(e.number - M_PI) < 1e-3;
    return itself || number || std::ranges::any_of(e.operands, [](const ast::ExprPtr &operand) {
               return mentionsPi(*operand);
           });
}

bool looksLikeRadians(const ast::Expr &angle) {
    if (angle.kind == ast::ExprKind::Number)
        return angle.number > 0 && angle.number <= 2 * M_PI + 1e-3;
    bool converted = angle.kind == ast::ExprKind::Call && angle.text == "degrees";
    return !converted && mentionsPi(angle);
}

bool looksLikeDegrees(const ast::Expr &angle) {
    constexpr double step = 5; // 30, 45, 90: nobody turns by ten radians without meaning degrees.
    if (angle.kind == ast::ExprKind::Number)
        return angle.number > 2 * M_PI + 1e-3 && std::fmod(angle.number, step) == 0;
    return angle.kind == ast::ExprKind::Call && angle.text == "degrees";
}

} // namespace candela::sl
