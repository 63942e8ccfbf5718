// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/student.h"

#include <cmath>
#include <numbers>

namespace candela {

MeanAndError meanAndError(const std::vector<double> &values) {
    MeanAndError result;
    for (double value : values)
        result.mean += value;
    result.mean /= double(values.size());
    double squares = 0;
    for (double value : values)
        squares += (value - result.mean) * (value - result.mean);
    double count = double(values.size());
    result.standardError = std::sqrt(squares / (count - 1) / count);
    return result;
}

// The integral of the density is a finite sum in the angle atan(t / sqrt(degrees)): powers of its
// cosine, even ones for even degrees, odd ones for odd degrees.
double studentTail(double t, int degreesOfFreedom) {
    double angle = std::atan(t / std::sqrt(double(degreesOfFreedom)));
    double sine = std::sin(angle), cosine = std::cos(angle);
    bool odd = degreesOfFreedom % 2 == 1;
    double term = odd ? cosine : 1, sum = degreesOfFreedom > 1 ? term : 0;
    for (int k = odd ? 3 : 2; k < degreesOfFreedom; k += 2) {
        term *= cosine * cosine * (k - 1) / k;
        sum += term;
    }
    double inside = odd ? 2 / std::numbers::pi * (angle + sine * sum) : sine * sum;
    return 1 - inside;
}

double studentQuantile(double probability, int degreesOfFreedom) {
    double low = 0, high = 1;
    while (studentTail(high, degreesOfFreedom) > probability)
        high *= 2;
    for (int step = 0; step < 100; ++step) {
        double middle = (low + high) / 2;
        (studentTail(middle, degreesOfFreedom) > probability ? low : high) = middle;
    }
    return high;
}

} // namespace candela
