// SPDX-License-Identifier: Apache-2.0
// The constants of the RGB mode against photometry by wavelength (VALIDATION H1).
#include "foundation/units/color.h"

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace candela {
namespace {

/// CIE 1931 y-bar at 380, 385 ... 780 nm.
constexpr std::array<double, 81> luminousEfficiency{
    .000039,  .000064,  .00012,  .000217,  .000396, .00064,   .00121, .00218,   .004,
    .0073,    .0116,    .01684,  .023,     .0298,   .038,     .048,   .06,      .0739,
    .09098,   .1126,    .13902,  .1693,    .20802,  .2586,    .323,   .4073,    .503,
    .6082,    .71,      .7932,   .862,     .91485,  .954,     .9803,  .99495,   1,
    .995,     .9786,    .952,    .9154,    .87,     .8163,    .757,   .6949,    .631,
    .5668,    .503,     .4412,   .381,     .321,    .265,     .217,   .175,     .1382,
    .107,     .0816,    .061,    .04458,   .032,    .0232,    .017,   .01192,   .00821,
    .005723,  .004102,  .002929, .002091,  .001484, .001047,  .00074, .00052,   .0003611,
    .0002492, .0001719, .00012,  .0000848, .00006,  .0000424, .00003, .0000212, .00001499};

constexpr double mostEfficacy = 683.002;         ///< lm/W, at 555 nm
constexpr double stepWidth = 5, bandWidth = 400; ///< nm

double luminanceOfConstantSpectrum() {
    return mostEfficacy * stepWidth *
           std::accumulate(luminousEfficiency.begin(), luminousEfficiency.end(), 0.0);
}

/// 1 W m^-2 sr^-1 nm^-1 at all wavelengths. Steps of 5 nm leave 3e-6 of the sum over 1 nm.
TEST(Photometry, ASpectralConstantHasItsLuminance) {
    EXPECT_NEAR(luminanceOfConstantSpectrum() / 72983.47, 1, 1e-5);
}

/// Equal-energy light over the band: 182.46 lm/W. The RGB mode's 179 is Radiance's definition, 2 %
/// below.
TEST(Photometry, TheRgbModesEfficacyIsThatOfEqualEnergyWhiteToTwoPerCent) {
    const double white = luminanceOfConstantSpectrum() / bandWidth;
    EXPECT_NEAR(white, 182.46, .005);
    EXPECT_EQ(luminousEfficacy, 179);
    EXPECT_NEAR(luminousEfficacy / white, 1, .02);
}

/// So white of one unit has 179 cd/m^2, by whatever way.
TEST(Photometry, WhiteHasLuminanceOne) { EXPECT_NEAR(luminance(Color(1)), 1, 1e-7); }

} // namespace
} // namespace candela
