// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts that come with the program. They are made for flat films, whose picture is 10 m high.
#include "commands/parts.h"

namespace betwixt {
namespace {

constexpr PartRow rows[] = {
    {"lower-third", "A name and a line below it on a band at the lower left, which slides in and out.",
     " title=\"Name\" subtitle=\"\" from=1f lasts=4s ink=#f5f7fa paint=#2a6fdb",
     R"part(  create slide group
  create slide/band rectangle size=(6.6 1.3) position=(-5.1 -3.6 0.1) color=paint corner=0.12
  create slide/title text text=title size=0.5 align="left" position=(-8 -3.5 0.2) color=ink
  create slide/subtitle text text=subtitle size=0.32 align="left" position=(-8 -4.05 0.2) color=ink
  slide.position.x
    from -9 ease-out
    from+12f 0 hold
    from+lasts-12f 0 ease-in
    from+lasts -9
)part"},
    {"title-card", "A large title with a line below it, in the middle of the picture.",
     " title=\"Title\" subtitle=\"\" from=1f lasts=3s ink=#f5f7fa",
     R"part(  create title text text=title size=1.1 align="centre" position=(0 0.1 0.2) color=ink
  create rule rectangle size=(4 0.06) position=(0 -0.5 0.2) color=ink
  create subtitle text text=subtitle size=0.5 align="centre" position=(0 -1.25 0.2) color=ink
  {title,subtitle}.transparency
    from 1 linear
    from+12f 0 hold
    from+lasts-12f 0 linear
    from+lasts 1
  rule.size.x
    from 0 ease-out
    from+18f 4 hold
    from+lasts-12f 4 ease-in
    from+lasts 0
)part",
     true},
    {"chart-frame", "A panel with a heading and a source, behind a chart.",
     " title=\"\" source=\"\" width=13 height=8 ink=#dfe3e8 paint=#20242c",
     R"part(  create panel rectangle size=(width height) position=(0 0 -0.3) color=paint corner=0.2
  create title text text=title size=0.5 align="left" position=(0.4-width/2 height/2-0.85 0) color=ink
  create source text text=source size=0.22 align="left" position=(0.4-width/2 0.25-height/2 0) color=ink transparency=0.4
)part"},
    {"device-frame", "A phone or a screen around a picture: things at its centre are on its screen.",
     " width=4 height=7.2 paint=#0b0d11 screen=#f5f7fa",
     R"part(  create body rectangle size=(width+0.5 height+0.9) position=(0 0 -0.3) color=paint corner=0.5
  create screen rectangle size=(width height) position=(0 0 -0.2) color=screen corner=0.15
  create button rectangle size=(1 0.07) position=(0 -height/2-0.25 -0.1) color=screen corner=0.03 transparency=0.4
)part"},
    {"credits", "Lines of text that move up through the picture.",
     " text=\"Directed by\\nAnn\" from=1f lasts=6s size=0.5 travel=14 ink=#f5f7fa",
     R"part(  create lines text text=text size=size align="centre" color=ink position=(0 -travel/2 0.2)
  lines.position.y
    from -travel/2 linear
    from+lasts travel/2
)part",
     true},
    {"countdown", "Numbers that count seconds down, in a ring that empties.",
     " seconds=5 start=0s size=1.6 ink=#f5f7fa paint=#e0533d",
     R"part(  create ring arc radius=size width=size*0.16 color=paint position=(0 0 0.1)
  ring.from
    start 90deg linear
    start+seconds*1s 450deg
  set ring.to 450deg
  create number text size=size align="centre" position=(0 -size*0.36 0.2) color=ink
  set number.text = "string.format('%.0f', math.max(0, math.ceil(seconds - (t - start))))"
)part",
     true},
    {"map-pin", "A pin whose tip is at its place, with a label above it.",
     " label=\"\" size=1 paint=#e0533d ink=#f5f7fa",
     R"part(  create tip polygon points=((0 0) (-size*0.26 size*0.52) (size*0.26 size*0.52)) color=paint
  create head circle radius=size*0.32 position=(0 size*0.68 0.01) color=paint
  create hole circle radius=size*0.12 position=(0 size*0.68 0.02) color=white
  create label text text=label size=size*0.32 align="centre" position=(0 size*1.12 0.02) color=ink
)part",
     true},
    {"speech-bubble", "A text in a bubble, whose tip is at its place.",
     " text=\"Hello\" width=4.4 height=1.5 size=0.42 paint=#f5f7fa ink=#16181d",
     R"part(  create tip polygon points=((0 0) (0.35 0.75) (0.95 0.75)) color=paint
  create bubble rectangle size=(width height) position=(width/2-0.3 0.7+height/2 0) color=paint corner=0.3
  create text text text=text size=size wrap=width-0.6 anchor="middle" color=ink position=(width/2-0.3 0.7+height/2 0.1)
)part"},
};

}  // namespace

std::span<const PartRow> part_rows() { return rows; }

}  // namespace betwixt
