// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The film that a new user sees first.
#pragma once

namespace betwixt::studio {

inline constexpr const char* example_film = R"(# A ball bounces into a hand, which carries it away and lets it go.
# Press space. Then change a number here: the picture follows at once.
rate 24
range 1f 96f
ground on
create eye camera position=(0 3.2 13) look-at=(0 1.6 0) lens=40mm
create ball sphere radius=0.5 color=gold
create hand box size=(1.6 0.25 1.2) color=steelblue

# where the ball is, and when
ball.position
  1f   (-6 0.5 0)
  12f  (-4 3.5 0)
  24f  (-2 0.5 0)
  34f  (-0.6 2.6 0)
  44f  (0.9 1.4 0)

# it is squashed where it hits the ground
ball.scale
  21f  (1 1 1)
  24f  (1.25 0.7 1.25)
  27f  (1 1 1)

hand.position
  1f   (1 1 0)
  44f  (1 0.775 0)
  48f  (1 0.6 0)
  66f  (5 3 0)
  84f  (5 1 0)

# from here on the hand carries it, and here it lets it go
at 44f attach ball to hand keep-world
at 66f letgo ball
at 66f note "let go in mid-motion"
at 66f fall ball
)";

}  // namespace betwixt::studio
