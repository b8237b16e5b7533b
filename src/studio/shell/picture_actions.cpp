// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Actions that change only what the picture shows, and how a hand moves things in it.
#include "studio/shell/actions.h"
#include "studio/shell/sound.h"
#include "studio/shell/window.h"
#include "studio/viewport/views.h"

namespace betwixt::studio {
namespace {

template <bool ViewportSwitches::*which>
ActionRow toggle(std::string_view name, std::string_view sentence, std::string_view also) {
  return {"Picture",
          name,
          "",
          sentence,
          [](Window& w) { w.viewport().flip(which); },
          [](const Window& w) { return w.viewport().switches().*which; },
          also};
}

}  // namespace

std::vector<ActionRow> picture_rows() {
  return {
      {"Play", "Preview", "P",
       "Makes all pictures of the part that plays, keeps them in memory, and plays them at the film's rate.",
       [](Window& w) { w.views().first().fill_memory(); },
       [](const Window& w) { return w.views().first().fills_memory(); }, "ram preview cache render playback"},
      {"Play", "Sound while dragging", "", "You hear a short piece of the film's sound where you drag the playhead.",
       [](Window& w) { w.sound().set_heard_in_drags(!w.sound().is_heard_in_drags()); },
       [](const Window& w) { return w.sound().is_heard_in_drags(); }, "audio scrubbing scrub lip sync"},
      {"Picture", "Isolate selection", "/", "Shows only the selection and the lights; once more shows everything.",
       [](Window& w) { w.viewport().isolate(); }, [](const Window& w) { return w.workspace().left_out() != nullptr; },
       "local view solo hide others"},
      {"Picture", "Four views", "Ctrl+Alt+Q",
       "Looks from above, from the front, from the right and through the camera.",
       [](Window& w) { w.views().set_four(!w.views().are_four()); },
       [](const Window& w) { return w.views().are_four(); }, "quad view split orthographic layout"},
      {"Picture", "Look through selection", "",
       "Looks through a light, a camera or another object, and goes with it; once more looks as before.",
       [](Window& w) { w.viewport().look_through(); },
       [](const Window& w) { return static_cast<bool>(w.viewport().looks_through()); },
       "light view set active object as camera"},
      {"Picture", "Move selected to view", "",
       "Moves the object that you selected last to where the free view looks from: `set key.position (1 2 3)`.",
       [](Window& w) { w.viewport().bring_selected(); }, nullptr, "align active object to view light"},
      toggle<&ViewportSwitches::safe>("Safe frames", "Shows what is surely visible: 90 % for action, 80 % for titles.",
                                      "action safe title safe areas margins overscan"),
      toggle<&ViewportSwitches::key_ghosts>("Ghosts of events", "Shows the selection at its event before and its next.",
                                            "onion skin previous next pose"),
      toggle<&ViewportSwitches::snaps>(
          "Snapping", "What you move goes to points and surfaces of other objects; with Ctrl in steps of a grid.",
          "magnet snap vertex face grid align"),
      toggle<&ViewportSwitches::measures>("Measure", "Click two points: you see their distance. Escape ends it.",
                                          "ruler distance length tape"),
      toggle<&ViewportSwitches::guides>(
          "Rulers and guides",
          "In views along an axis, without perspective: drag a guide out of a ruler, and back to remove it. What you "
          "move goes to guides.",
          "guide ruler snap align layout line"),
      {"Picture", "Guide at…", "", "Type `x 2.5` for a guide there; the same once more removes it.",
       [](Window& w) { w.viewport().ask_guide(); }, nullptr, "add ruler line place"},
      {"Picture", "Guides at selection", "",
       "Puts guides through the middle of the object that you selected last; once more removes them.",
       [](Window& w) { w.viewport().guide_selection(); }, nullptr, "add ruler line align"},
      {"Picture", "Remove guides", "", "Removes all guides of this film.",
       [](Window& w) {
         ViewportSwitches s = w.viewport().switches();
         s.own_guides.clear();
         w.viewport().set_switches(s);
       },
       nullptr, "clear delete ruler"},
      toggle<&ViewportSwitches::thirds>("Thirds", "Divides the film's frame into nine equal parts.",
                                        "rule of thirds composition guides"),
  };
}

}  // namespace betwixt::studio
