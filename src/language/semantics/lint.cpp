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
    if (angle.kind == ast::ExprKind::Number) {
        // A part of pi, as a twelfth is, or some of these: the sun's disc of .53 degrees is not.
        constexpr double part = M_PI / 12, near = 2e-3;
        const double parts = std::round(angle.number / part);
        return parts >= 1 && parts <= 24 && std::abs(angle.number - parts * part) < near;
    }
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
