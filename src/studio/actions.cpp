// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/actions.h"

#include "studio/window.h"

namespace betwixt::studio {

const std::vector<ActionRow>& action_rows() {
  static const std::vector<ActionRow> all = {
      {"File", "Open…", "Ctrl+O", "Goes on with another script: `open FILE`.", [](Window& w) { w.open_asking(); }},
      {"File", "Save", "Ctrl+S", "Writes the script: `save`.", [](Window& w) { w.save(); }},
      {"File", "Quit", "Ctrl+Q", "Ends; asks first where something is not saved: `quit`.",
       [](Window& w) { w.close(); }},
      {"Edit", "Undo", "Ctrl+Z", "Takes back the last thing done, without limit: `undo`.",
       [](Window& w) { w.desk().undo(); }},
      {"Edit", "Redo", "Ctrl+Shift+Z; Ctrl+Y", "Does again what was taken back: `redo`.",
       [](Window& w) { w.desk().redo(); }},
      {"Play", "Play", "Space", "Plays from here, or stops.",
       [](Window& w) { w.desk().transport().playing() ? w.desk().pause() : w.desk().play(1); }},
      {"Play", "Play backwards", "Shift+Space", "Plays from here to the beginning, or stops.",
       [](Window& w) { w.desk().transport().playing() ? w.desk().pause() : w.desk().play(-1); }},
      {"Play", "Again and again", "L", "At its end it goes on from the beginning.",
       [](Window& w) { w.desk().transport().loop(!w.desk().transport().loops()); },
       [](const Window& w) { return w.desk().transport().loops(); }},
      {"Play", "Next frame", "Right", "One frame on.", [](Window& w) { w.desk().step(1); }},
      {"Play", "Frame before", "Left", "One frame back.", [](Window& w) { w.desk().step(-1); }},
      {"Play", "To the beginning", "Home", "To the first frame of what is played.",
       [](Window& w) { w.desk().go_to(w.desk().transport().first()); }},
      {"Play", "To the end", "End", "To the last frame of what is played.",
       [](Window& w) { w.desk().go_to(w.desk().transport().last()); }},
  };
  return all;
}

}  // namespace betwixt::studio
