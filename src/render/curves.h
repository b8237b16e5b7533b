// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Powers and the sRGB curve for pictures, with the same bits on every machine, which those of the C library have not.
#pragma once

namespace betwixt {

// The logarithm to base 2 of a positive, finite, normal number, within 1e-14.
double own_log2(double);
// 2 to the power of x, |x| < 1000, within 1e-14 of its size.
double own_exp2(double x);
inline double own_power(double base, double exponent) { return own_exp2(exponent * own_log2(base)); }

// The sRGB curve and its inverse, within 1e-7, from 0 to 1; what is outside is clamped, NaN becomes 0.
double signal_of(double light);
double light_of_signal(double signal);

}  // namespace betwixt
