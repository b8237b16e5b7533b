// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the colours of a ColorTable are that takes light in stops: from 0 for no light to 1 for light of 128.4, with
// white at 9/16, which is a place in tables of 65 and 4097. There are 28 places a unit of log2(light), fewer in the
// dark.
#pragma once

namespace betwixt {

inline constexpr double dark_stops = 512;                    // a share of light of 1/512 is where steps of stops begin
inline constexpr double stops_to_white = 9.002815015607053;  // log2(1 + dark_stops)
inline constexpr double place_of_white = 9.0 / 16;
// place = place_of_white / stops_to_white * log2(1 + dark_stops * light)

}  // namespace betwixt
