// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/actions.h"

#include "studio/event_hands.h"
#include "studio/sound.h"
#include "studio/viewport.h"
#include "studio/window.h"

namespace betwixt::studio {

const std::vector<ActionRow>& action_rows() {
  static const std::vector<ActionRow> all = {
      {"File", "New", "Ctrl+N", "Begins a new film; asks first where something is not saved.",
       [](Window& w) { w.new_film(); }},
      {"File", "Open…", "Ctrl+O", "Goes on with another script: `open FILE`.", [](Window& w) { w.open_asking(); }},
      {"File", "Save", "Ctrl+S", "Writes the script: `save`.", [](Window& w) { w.save(); }},
      {"File", "Save as…", "Ctrl+Shift+S", "Writes the script under another name: `save FILE`.",
       [](Window& w) { w.save_as(); }},
      {"File", "Make a film…", "Ctrl+R; F12", "The film as a file: `betwixt render`.",
       [](Window& w) { w.make_film(); }},
      {"File", "Save what was said…", "",
       "The lines of this session as a file: said again, by `betwixt studio --session`, they make the same film.",
       [](Window& w) { w.save_session(); }},
      {"File", "Open an example", "", "A ball, a hand, and what they do.", [](Window& w) { w.open_example(); }},
      {"File", "Quit", "Ctrl+Q", "Ends; asks first where something is not saved: `quit`.",
       [](Window& w) { w.close(); }},
      {"Edit", "Undo", "Ctrl+Z", "Takes back the last thing done, without limit: `undo`.",
       [](Window& w) { w.desk().undo(); }},
      {"Edit", "Redo", "Ctrl+Shift+Z; Ctrl+Y", "Does again what was taken back: `redo`.",
       [](Window& w) { w.desk().redo(); }},
      {"Edit", "An event at the playhead", "K", "Of each track of what is selected: `at T TARGET VALUE`.",
       [](Window& w) { EventHands::of(w.desk()).insert(); }},
      {"Play", "Play", "Space", "Plays from here, or stops.",
       [](Window& w) { w.desk().transport().playing() ? w.desk().pause() : w.desk().play(1); }},
      {"Play", "Play backwards", "Shift+Space", "Plays from here to the beginning, or stops.",
       [](Window& w) { w.desk().transport().playing() ? w.desk().pause() : w.desk().play(-1); }},
      {"Play", "Again and again", "L", "At its end it goes on from the beginning.",
       [](Window& w) { w.desk().transport().loop(!w.desk().transport().loops()); },
       [](const Window& w) { return w.desk().transport().loops(); }},
      {"Play", "Without sound", "Ctrl+M", "Whether the film's sounds are heard while it plays.",
       [](Window& w) { w.sound().mute(!w.sound().muted()); }, [](const Window& w) { return w.sound().muted(); }},
      {"Play", "Next frame", "Right", "One frame on.", [](Window& w) { w.desk().step(1); }},
      {"Play", "Frame before", "Left", "One frame back.", [](Window& w) { w.desk().step(-1); }},
      {"Play", "To the beginning", "Home", "To the first frame of what is played.",
       [](Window& w) { w.desk().go_to(w.desk().transport().first()); }},
      {"Play", "To the end", "End", "To the last frame of what is played.",
       [](Window& w) { w.desk().go_to(w.desk().transport().last()); }},
      {"Play", "A part begins here", "I", "From here on is played, to the end of the part.",
       [](Window& w) {
         const Time t = w.desk().time();
         w.desk().set_range(std::pair(t, std::max(t, w.desk().transport().last())));
       }},
      {"Play", "A part ends here", "O", "Up to here is played, from the beginning of the part.",
       [](Window& w) {
         const Time t = w.desk().time();
         w.desk().set_range(std::pair(std::min(t, w.desk().transport().first()), t));
       }},
      {"Play", "All of it", "X", "The whole film is played again.",
       [](Window& w) { w.desk().set_range(std::nullopt); }},
      {"Picture", "Free view", "", "From where one likes, or through the film's camera; in the picture, 0.",
       [](Window& w) { w.viewport().set_free(!w.viewport().is_free()); },
       [](const Window& w) { return w.viewport().is_free(); }},
      {"Picture", "See what is selected", "", "All of it, or all there is; in the picture, F.",
       [](Window& w) { w.viewport().frame_selected(); }},
      {"Picture", "From the front", "", "Along -z; in the picture, 1, and 9 for the other side.",
       [](Window& w) {
         w.viewport().look_along({0, 0, -1});
       }},
      {"Picture", "From the right", "", "Along -x; in the picture, 3, and 9 for the other side.",
       [](Window& w) {
         w.viewport().look_along({-1, 0, 0});
       }},
      {"Picture", "From above", "", "Along -y; in the picture, 7, and 9 for the other side.",
       [](Window& w) {
         w.viewport().look_along({0, -1, 0});
       }},
      {"Picture", "With perspective or without", "", "In the picture, 5.",
       [](Window& w) { w.viewport().toggle_perspective(); }},
      {"Picture", "The camera comes here", "",
       "The film's camera, to the free eye's place: `set eye.position (1 2 3)`.",
       [](Window& w) { w.viewport().bring_camera(); }},
      {"Picture", "Move what is selected", "", "As the pointer goes; in the picture, G: `set ball.position (1 2 3)`.",
       [](Window& w) { w.viewport().take(Tool::move); }},
      {"Picture", "Turn what is selected", "", "In the picture, R: `set ball.rotation euler(0 90deg 0)`.",
       [](Window& w) { w.viewport().take(Tool::turn); }},
      {"Picture", "Scale what is selected", "", "In the picture, S: `set ball.scale (2 2 2)`.",
       [](Window& w) { w.viewport().take(Tool::scale); }},
      {"Picture", "Every change an event", "", "At the playhead: `at 24f ball.position (1 2 3)`.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::auto_key); },
       [](const Window& w) { return w.viewport().switches().auto_key; }},
      {"Picture", "Ways", "", "Where what is selected goes.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::trails); },
       [](const Window& w) { return w.viewport().switches().trails; }},
      {"Picture", "Onion skin", "", "Where things were and will be some frames away.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::ghosts); },
       [](const Window& w) { return w.viewport().switches().ghosts; }},
      {"Picture", "Grid", "", "On the ground.", [](Window& w) { w.viewport().flip(&ViewportSwitches::grid); },
       [](const Window& w) { return w.viewport().switches().grid; }},
      {"View", "Find a command…", "Ctrl+Shift+P; F3", "Whatever can be done, by a few of its letters.",
       [](Window& w) { w.find_command(); }},
      {"View", "Light colours", "", "Light or dark.", [](Window& w) { w.set_light(!w.is_light()); },
       [](const Window& w) { return w.is_light(); }},
      {"View", "To the console", "Ctrl+Return; F4", "Where lines of the language are said.",
       [](Window& w) { w.show_panel("console"); }},
      {"View", "To the script", "Ctrl+E", "The text of the film.", [](Window& w) { w.show_panel("script_panel"); }},
      {"View", "To the picture", "Ctrl+1", "Where things are moved.", [](Window& w) { w.show_panel("viewport"); }},
      {"View", "To the sheet", "Ctrl+2", "Events against time.", [](Window& w) { w.show_panel("sheet"); }},
      {"View", "To the curves", "Ctrl+3", "Values against time.", [](Window& w) { w.show_panel("curves"); }},
      {"View", "To the properties", "Ctrl+4", "What is selected, and its values.",
       [](Window& w) { w.show_panel("properties"); }},
      {"View", "To the controls", "Ctrl+5", "OSC and MIDI: what comes in, and what it turns.",
       [](Window& w) { w.show_panel("live"); }},
      {"View", "To a server", "Ctrl+6", "A running imaging server, watched and steered.",
       [](Window& w) { w.show_panel("server"); }},
      {"View", "All keys", "F1", "What each key does.", [](Window& w) { w.show_keys(); }},
  };
  return all;
}

}  // namespace betwixt::studio
