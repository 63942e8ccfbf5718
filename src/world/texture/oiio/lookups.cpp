// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/lookups.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr int mostValues = 3;

/// One lane's operands, made harmless: no shader's mistake reaches the library.
struct Lookup {
    Lookup(const LookupRow &row, int lane) : operands(row.operands + lane), lanes(row.lanes) {}

    const float *operands;
    const int lanes;

    float number(LookupOperand operand, float least, float most, float otherwise) const {
        const float value = operands[int(operand) * lanes];
        return std::isfinite(value) ? std::clamp(value, least, most) : otherwise;
    }
    float place(LookupOperand operand) const { return number(operand, -1e6f, 1e6f, 0); }
    float middle(LookupOperand operand, LookupOperand shift) const {
        return place(operand) + number(shift, -64, 64, 0);
    }
    float extent(LookupOperand operand) const { return number(operand, -64, 64, 64); }
    float blur(LookupOperand operand) const { return number(operand, 0, 64, 0); }
};

/// Which channels of the file become the values.
struct Channels {
    int first = 0, count = 0; ///< Of the file's; count 0: none is there.
};

/// Three values of a file that has fewer are one of its channels, three times.
Channels channelsOf(int inFile, int first, int values) {
    if (first >= inFile)
        return {};
    return {first, values == mostValues && inFile - first >= mostValues ? mostValues : 1};
}

/// OpenImageIO averages along the longer axis of an anisotropic footprint, M metres over a shorter
/// one of m, with the variance (M - m)^2 / 4 + m^2 / 12, which is up to three times that of a box
/// as long as the axis: measured on a step. The axis is made shorter by as much.
struct Footprint {
    float dsdx, dtdx, dsdy, dtdy;

    void matchBox() {
        // Its averages have longer tails than a box has: on a chequered plane to the horizon
        // (tests/textures) this share of the length comes nearest to one.
        constexpr float share = 0.88f;
        dsdx *= share, dtdx *= share, dsdy *= share, dtdy *= share;
        const float x = std::hypot(dsdx, dtdx), y = std::hypot(dsdy, dtdy);
        if (!(x > 0 && y > 0))
            return;
        const float longer = std::max(x, y), shorter = std::min(x, y);
        const float root = std::sqrt((longer * longer - shorter * shorter) / 3);
        const float factor = (shorter + root) / longer;
        (x > y ? dsdx : dsdy) *= factor, (x > y ? dtdx : dtdy) *= factor;
    }

    /// OpenImageIO 2.4 subtracts to find the width of a footprint, and ends the process where that
    /// leaves 0 and blur is to be added: a surface from its edge, or coordinates one of which
    /// stands still. It takes widths of less than a 64th of the length (its anisotropy) for one.
    void giveWidth() {
        constexpr double least = 1.0 / 1024;
        const double ss = double(dsdx) * dsdx + double(dsdy) * dsdy;
        const double tt = double(dtdx) * dtdx + double(dtdy) * dtdy;
        const double st = double(dsdx) * dtdx + double(dsdy) * dtdy;
        const double length2 = (ss + tt + std::hypot(ss - tt, 2 * st)) / 2;
        const double area = std::abs(double(dsdx) * dtdy - double(dsdy) * dtdx);
        if (area >= length2 * least) // Nothing at all is wide enough for it, too.
            return;
        const double angle = std::atan2(2 * st, ss - tt) / 2, length = std::sqrt(length2);
        dsdx = float(length * std::cos(angle)), dtdx = float(length * std::sin(angle));
        dsdy = -dtdx * float(least), dtdy = dsdx * float(least);
    }
};

struct Answer {
    float value[mostValues] = {}, byS[mostValues] = {}, byT[mostValues] = {};
};

void store(const LookupRow &row, int lane, const Channels &channels, const Answer &answer) {
    const auto plane = [&](int first, const float *from) {
        for (int k = 0; k < row.values; ++k)
            row.results[(first + k) * row.lanes + lane] = from[std::min(k, channels.count - 1)];
    };
    plane(0, answer.value);
    if (row.slopes)
        plane(row.values, answer.byS), plane(2 * row.values, answer.byT);
}

void storeFill(const LookupRow &row, int lane, float fill) {
    for (int k = 0; k < row.values; ++k)
        row.results[k * row.lanes + lane] = fill;
}

OIIO::TextureOpt optionsOf(const PictureLibrary::Opened &picture, const LookupRow &row) {
    OIIO::TextureOpt options;
    options.anisotropic = 64;
    if (!picture.saysWrap)
        options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
    if (row.around) {
        options.swrap = OIIO::TextureOpt::WrapPeriodic;
        options.twrap = OIIO::TextureOpt::WrapClamp;
    }
    return options;
}

} // namespace

bool lookUp(OIIO::TextureSystem &system, const PictureLibrary::Opened &picture,
            const LookupRow &row) {
    OIIO::TextureSystem::Perthread *thread = system.get_perthread_info();
    OIIO::TextureOpt options = optionsOf(picture, row);
    bool good = true;
    for (int lane = 0; lane < row.lanes; ++lane) {
        if (!(row.mask >> lane & 1))
            continue;
        using enum LookupOperand;
        const Lookup at(row, lane);
        const Channels channels =
            channelsOf(picture.channels, int(at.number(channel, 0, 65536, 0)), row.values);
        if (channels.count == 0) {
            storeFill(row, lane, at.number(fill, -1e30f, 1e30f, 0));
            continue;
        }
        options.firstchannel = channels.first;
        options.sblur = at.blur(sBlur), options.tblur = at.blur(tBlur);
        Footprint footprint{at.extent(dsdx), at.extent(dtdx), at.extent(dsdy), at.extent(dtdy)};
        footprint.matchBox();
        if (options.sblur + options.tblur > 0)
            footprint.giveWidth();
        Answer answer;
        const bool found = system.texture(
            picture.handle, thread, options, at.middle(s, sShift), at.middle(t, tShift),
            footprint.dsdx, footprint.dtdx, footprint.dsdy, footprint.dtdy, channels.count,
            answer.value, row.slopes ? answer.byS : nullptr, row.slopes ? answer.byT : nullptr);
        if (found)
            store(row, lane, channels, answer);
        good &= found;
    }
    return good;
}

} // namespace candela
