// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/actions.h"

#include <algorithm>

#include "studio/curves/curve_actions.h"
#include "studio/objects/object_actions.h"
#include "studio/objects/staging.h"
#include "studio/poses/pose_actions.h"
#include "studio/shell/preferences.h"
#include "studio/shell/sound.h"
#include "studio/shell/window.h"
#include "studio/timeline/event_actions.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

namespace {

// The actions on objects (ObjectActions): the panels that show objects have their keys.
std::vector<ActionRow> object_rows() {
  std::vector<ActionRow> rows{{"Object", "Add object", "", "Shows the kinds of objects to create: `create NAME KIND`.",
                               [](Window& w) { w.add_object(); }}};
  for (const ObjectActions::Row& row : ObjectActions::rows())
    rows.push_back({"Object", row.name, "", row.sentence,
                    [run = row.run](Window& w) { (ObjectActions::of(w.workspace()).*run)(); }});
  const auto with_axis = [&]<Axis axis>(std::string_view mirror, std::string_view align, std::string_view distribute) {
    const auto add = [&](std::string_view name, std::string_view sentence, auto run) {
      rows.push_back({"Object", name, "", sentence, run});
    };
    add(mirror, "Makes a twin that mirrors the selection with all its motion.",
        [](Window& w) { ObjectActions::of(w.workspace()).mirror(axis); });
    add(align, "Moves the others to the place of the object that you selected last, along this axis.",
        [](Window& w) { ObjectActions::of(w.workspace()).align(axis); });
    add(distribute, "Spreads three or more objects evenly along this axis.",
        [](Window& w) { ObjectActions::of(w.workspace()).distribute(axis); });
  };
  with_axis.operator()<Axis::x>("Mirror along x", "Align along x", "Distribute along x");
  with_axis.operator()<Axis::y>("Mirror along y", "Align along y", "Distribute along y");
  with_axis.operator()<Axis::z>("Mirror along z", "Align along z", "Distribute along z");
  rows.push_back({"Object", "Pivot to the bottom", "", "Objects turn and scale about their pivot: `set ball.pivot …`.",
                  [](Window& w) { ObjectActions::of(w.workspace()).pivot(true); }});
  rows.push_back({"Object", "Pivot to the middle", "", "Objects turn and scale about their pivot: `set ball.pivot …`.",
                  [](Window& w) { ObjectActions::of(w.workspace()).pivot(false); }});
  rows.push_back({"Object", "Replace shape by a file…", "",
                  "Gives the selection the shape of a file; its name, tracks and attachments stay: `set cow.file …`.",
                  [](Window& w) { ObjectActions::of(w.workspace()).replace_by_file(); }});
  return rows;
}

// What brings objects on, takes them off and points at them.
std::vector<ActionRow> animation_rows() {
  std::vector<ActionRow> rows;
  for (const StagingRow& row : staging_rows()) {
    rows.push_back({"Animation", row.name, "", row.sentence, [&row](Window& w) { stage(w.workspace(), row); }});
    rows.back().also = row.also;
    const bool new_sort = &row != staging_rows().data() && row.sort != (&row - 1)->sort;
    rows.back().divides = new_sort && row.sort != StagingSort::unmark;
  }
  return rows;
}

// The words of other programs.
constexpr std::pair<std::string_view, std::string_view> other_words[] = {
    {"Insert event at playhead", "keyframe key set record"},
    {"Insert position, rotation and scale", "keyframe locrotscale transform whole"},
    {"Add object", "create new mesh cube primitive insert chart graph code formula"},
    {"Key preset…", "blender after effects keymap hotkeys shortcuts keyboard"},
    {"Manual", "help documentation guide handbook"},
    {"About Betwixt", "version licence license copyright"},
    {"Insert where it changed", "keyframe changed available"},
    {"Insert for the whole character", "keyframe all bones rig"},
    {"Hold until here", "keyframe freeze constant stepped pause"},
    {"Breakdown…", "inbetween in-between tween push pull relax breakdowner"},
    {"Handle type…", "tangent bezier interpolation keyframe aligned free vector auto clamped"},
    {"Twerper by its picture…", "interpolation easing keyframe ease easy-ease"},
    {"Simplify…", "decimate reduce clean curves keyframes smart"},
    {"Separate axes", "separate dimensions split xyz components"},
    {"Retime by a curve…", "time warp remap easing graph speed"},
    {"Paste pose mirrored", "flipped mirror left right"},
    {"Go to poses", "pose library asset"},
    {"Next event", "jump keyframe"},
    {"Previous event", "jump keyframe"},
    {"Add note…", "marker cue label bookmark"},
    {"Next note", "marker jump"},
    {"Previous note", "marker jump"},
    {"Auto-key", "automatic keyframe record"},
    {"Duplicate", "clone copy"},
    {"Duplicate linked", "instance clone reference"},
    {"Group", "parent empty null join"},
    {"Let fall", "gravity physics bounce rigid body drop"},
    {"Ungroup", "unparent"},
    {"Replace shape by a file…", "swap mesh relink footage model"},
    {"Pivot to the bottom", "origin anchor point floor"},
    {"Pivot to the middle", "origin anchor point center"},
    {"Remove", "delete erase"},
    {"Remove with all below", "delete hierarchy children"},
    {"Render film…", "export video mp4 gif animation composition"},
    {"New", "template preset project composition scene start"},
    {"Save session…", "macro"},
    {"Next film", "tab switch document project"},
    {"Previous film", "tab switch document project"},
    {"Close film", "tab document project"},
    {"Ways", "motion path trajectory trail"},
    {"Onion skin", "ghost"},
    {"Frame selection", "zoom fit view selected center"},
    {"Move camera to view", "align camera"},
    {"Go to curves", "graph editor f-curve interpolation easing"},
    {"Go to sheet", "dope timeline keyframes"},
    {"Go to history", "undo list"},
    {"Go to script", "text code source"},
    {"Set play range start", "in point work area"},
    {"Set play range end", "out point work area"},
    {"Free view", "orbit viewport camera"},
    {"Perspective", "orthographic"},
    {"Move selection", "translate grab position"},
    {"Rotate selection", "turn rotation"},
    {"Scale selection", "size resize"},
    {"Half speed", "slow motion"},
    {"Go to assets", "library browser project files materials colors swatches import"},
    {"Go to data", "table rows columns spreadsheet csv json sqlite"},
    {"Course", "tutorial learn lesson exercise beginner start"},
    {"Insert time…", "ripple gap delay"},
    {"Remove time", "ripple delete cut trim"},
    {"Preferences…", "settings options theme language shortcuts keymap colour blind"},
    {"All keys", "shortcuts hotkeys keymap cheat sheet"},
    {"Larger text", "font size scale zoom preferences"},
    {"Smaller text", "font size scale zoom preferences"},
    {"Light colours", "theme dark preferences"},
};

// The actions on events (keys) and poses.
std::vector<ActionRow> key_rows() {
  const auto events = [](Window& w) -> EventActions& { return EventActions::of(w.workspace()); };
  const auto poses = [](Window& w) -> PoseActions& { return PoseActions::of(w.workspace()); };
  return {
      {"Events", "Insert event at playhead", "K",
       "Inserts an event on each track of the selection: `at T TARGET VALUE`.", [=](Window& w) { events(w).insert(); }},
      {"Events", "Insert position, rotation and scale", "",
       "Inserts an event on each track of the selection, and on its position, rotation and scale even if they have "
       "none.",
       [=](Window& w) { events(w).insert_transforms(); }},
      {"Events", "Insert where it changed", "Alt+K",
       "Inserts an event only on those tracks of the selection that have changed since their last event.",
       [=](Window& w) { events(w).insert_changed(); }},
      {"Events", "Insert for the whole character", "Shift+K",
       "Inserts an event on each track of the selection, of its parents, and of all that hangs on them.",
       [=](Window& w) { events(w).insert_character(); }},
      {"Events", "Hold until here", "Alt+E",
       "The tracks of the selection keep the values of their last events up to the playhead: `hold`.",
       [=](Window& w) { events(w).hold(); }},
      {"Events", "Breakdown…", "Shift+E",
       "Inserts events at the playhead between the last and the next ones. A slider sets which they are nearer to.",
       [](Window& w) { w.ask_breakdown(); }},
      {"Events", "Retime by a curve…", "",
       "Moves the selected events in time, faster or slower by a curve; the first and the last one stay.",
       [](Window& w) { w.ask_retiming(); }},
      {"Events", "Next event", "Alt+Right", "Moves the playhead to the next event of the selection, or of all objects.",
       [=](Window& w) { events(w).go_to_event(1); }},
      {"Events", "Previous event", "Alt+Left", "Moves the playhead to the event before.",
       [=](Window& w) { events(w).go_to_event(-1); }},
      {"Events", "Handle type…", "",
       "How the curve passes the selected events: auto, smooth, straight, handles to drag, hold; in the sheet and the "
       "curves, V.",
       [](Window& w) { ask_key_type(w.workspace(), &w); }},
      {"Events", "Twerper by its picture…", "",
       "Chooses the twerper (easing) of the selected events from small pictures; in the sheet and the curves, T.",
       [](Window& w) { ask_twerper(w.workspace(), &w); }},
      {"Events", "Simplify…", "",
       "Removes the events that a tolerance makes unnecessary, and shows the result first: `clear …`.",
       [](Window& w) { ask_simplify(w.workspace(), &w); }},
      {"Events", "Separate axes", "",
       "Gives each component a track of its own, so that x, y and z can have events at different times: "
       "`ball.position.x`.",
       [](Window& w) { separate_axes(w.workspace()); }},
      {"Events", "Copy pose", "Ctrl+Shift+C",
       "Copies the values of the selection, with all that hangs on it, at the playhead as `set` lines.",
       [=](Window& w) { poses(w).copy(); }},
      {"Events", "Paste pose", "Ctrl+Shift+V",
       "Gives the copied pose to the selection at the playhead: `at T TARGET VALUE`.",
       [=](Window& w) { poses(w).paste(false); }},
      {"Events", "Paste pose mirrored", "Ctrl+Alt+V",
       "Gives the copied pose to the selection with left and right exchanged.",
       [=](Window& w) { poses(w).paste(true); }},
      {"Events", "Go to poses", "", "Shows the poses that are kept beside the film.",
       [](Window& w) { w.show_panel("poses"); }},
  };
}

std::vector<ActionRow> made_rows() {
  std::vector<ActionRow> all = {
      {"File", "New", "Ctrl+N", "Begins a new film, empty or from a template, in a tab of its own.",
       [](Window& w) { w.new_film(); }},
      {"File", "Open…", "Ctrl+O", "Opens another script, in a tab of its own: `open FILE`.",
       [](Window& w) { w.open_asking(); }},
      {"File", "Save", "Ctrl+S", "Writes the script: `save`.", [](Window& w) { w.save(); }},
      {"File", "Save as…", "Ctrl+Shift+S", "Writes the script under another name: `save FILE`.",
       [](Window& w) { w.save_as(); }},
      {"File", "Render film…", "Ctrl+R; F12", "Renders the film to a file: `betwixt render`.",
       [](Window& w) { w.make_film(); }},
      {"File", "Save session…", "",
       "Saves the lines of this session to a file; `betwixt studio --session` runs them again.",
       [](Window& w) { w.save_session(); }},
      {"File", "Open an example", "", "Opens a film with a ball and a hand.",
       [](Window& w) {
         if (Window* place = w.place_for_another()) place->open_example();
       }},
      {"File", "Next film", "Ctrl+Tab", "Goes to the film in the next tab.", [](Window& w) { w.go_to_film(1); }},
      {"File", "Previous film", "Ctrl+Shift+Tab", "Goes to the film in the tab before.",
       [](Window& w) { w.go_to_film(-1); }},
      {"File", "Close film", "Ctrl+W", "Closes the tab of this film; asks first if you have unsaved changes.",
       [](Window& w) { w.close_film(); }},
      {"File", "Quit", "Ctrl+Q", "Ends the program; asks first if you have unsaved changes: `quit`.",
       [](Window& w) { w.window()->close(); }},
      {"Edit", "Undo", "Ctrl+Z", "Undoes the last change, without limit: `undo`.",
       [](Window& w) { w.workspace().undo(); }},
      {"Edit", "Redo", "Ctrl+Shift+Z; Ctrl+Y", "Repeats the last undone change: `redo`.",
       [](Window& w) { w.workspace().redo(); }},
      {"Edit", "Add note…", "M", "Adds a note (a marker) at the playhead: `at T note \"…\"`.",
       [](Window& w) { w.add_note(); }},
      {"Edit", "Next note", "", "Moves the playhead to the next note.",
       [](Window& w) { EventActions::of(w.workspace()).go_to_note(1); }},
      {"Edit", "Previous note", "", "Moves the playhead to the note before.",
       [](Window& w) { EventActions::of(w.workspace()).go_to_note(-1); }},
      {"Edit", "Preferences…", "Ctrl+,", "Language, colours, sizes, keys and playback.",
       [](Window& w) { w.show_preferences(); }},
      {"Edit", "Key preset…", "", "The keys of Betwixt, of Blender or of After Effects; you can change each key.",
       [](Window& w) { w.show_preferences("Keyboard"); }},
      {"Edit", "Insert time…", "",
       "Makes room at the playhead: later events and notes, and the end of the film, come later: `move …`, `range …`.",
       [](Window& w) { w.insert_time(); }},
      {"Edit", "Remove time", "",
       "Removes the play range (I, O) with its events; what follows comes earlier: `clear …`, `move …`, `range …`.",
       [](Window& w) { w.remove_time(); }},
      {"Play", "Play", "Space", "Plays from the playhead, or stops.",
       [](Window& w) { w.workspace().playhead().playing() ? w.workspace().pause() : w.workspace().play(1); }},
      {"Play", "Play backwards", "Shift+Space", "Plays backwards from the playhead, or stops.",
       [](Window& w) { w.workspace().playhead().playing() ? w.workspace().pause() : w.workspace().play(-1); }},
      {"Play", "Loop", "L", "Plays again from the beginning at the end.",
       [](Window& w) { Preferences::of_user().set("loop", !w.workspace().playhead().loops()); },
       [](const Window& w) { return w.workspace().playhead().loops(); }},
      {"Play", "Half speed", "", "Plays half as fast, without sound; once more, as fast as the film.",
       [](Window& w) { w.workspace().playhead().speed(w.workspace().playhead().speed() == 0.5 ? 1 : 0.5); },
       [](const Window& w) { return w.workspace().playhead().speed() == 0.5; }},
      {"Play", "Double speed", "", "Plays twice as fast, without sound; once more, as fast as the film.",
       [](Window& w) { w.workspace().playhead().speed(w.workspace().playhead().speed() == 2 ? 1 : 2); },
       [](const Window& w) { return w.workspace().playhead().speed() == 2; }},
      {"Play", "Mute", "Ctrl+M", "Turns the film's sound off or on.",
       [](Window& w) { Preferences::of_user().set("mute", !w.sound().muted()); },
       [](const Window& w) { return w.sound().muted(); }},
      {"Play", "Next frame", "Right", "Moves the playhead one frame forwards.",
       [](Window& w) { w.workspace().step(1); }},
      {"Play", "Previous frame", "Left", "Moves the playhead one frame back.",
       [](Window& w) { w.workspace().step(-1); }},
      {"Play", "Go to start", "Home", "Moves the playhead to the first played frame.",
       [](Window& w) { w.workspace().go_to(w.workspace().playhead().first()); }},
      {"Play", "Go to end", "End", "Moves the playhead to the last played frame.",
       [](Window& w) { w.workspace().go_to(w.workspace().playhead().last()); }},
      {"Play", "Set play range start", "I", "Plays only from the playhead to the end of the play range.",
       [](Window& w) {
         const Time t = w.workspace().time();
         w.workspace().set_range(std::pair(t, std::max(t, w.workspace().playhead().last())));
       }},
      {"Play", "Set play range end", "O", "Plays only from the start of the play range to the playhead.",
       [](Window& w) {
         const Time t = w.workspace().time();
         w.workspace().set_range(std::pair(std::min(t, w.workspace().playhead().first()), t));
       }},
      {"Play", "Clear play range", "X", "Plays the whole film again.",
       [](Window& w) { w.workspace().set_range(std::nullopt); }},
      {"Picture", "Free view", "", "Switches between a free view and the film's camera.",
       [](Window& w) { w.viewport().set_free(!w.viewport().is_free()); },
       [](const Window& w) { return w.viewport().is_free(); }},
      {"Picture", "Frame selection", "", "Shows all selected objects, or all objects.",
       [](Window& w) { w.viewport().frame_selected(); }},
      {"Picture", "Front view", "", "Looks along -z.",
       [](Window& w) {
         w.viewport().look_along({0, 0, -1});
       }},
      {"Picture", "Right view", "", "Looks along -x.",
       [](Window& w) {
         w.viewport().look_along({-1, 0, 0});
       }},
      {"Picture", "Top view", "", "Looks along -y.",
       [](Window& w) {
         w.viewport().look_along({0, -1, 0});
       }},
      {"Picture", "Perspective", "", "Turns perspective on or off.",
       [](Window& w) { w.viewport().toggle_perspective(); }},
      {"Picture", "Move camera to view", "", "Moves the film's camera to the free view: `set eye.position (1 2 3)`.",
       [](Window& w) { w.viewport().bring_camera(); }},
      {"Picture", "Move selection", "", "Moves the selection with the pointer: `set ball.position (1 2 3)`.",
       [](Window& w) { w.viewport().take(Tool::move); }},
      {"Picture", "Rotate selection", "",
       "Rotates the selection with the pointer: `set ball.rotation euler(0 90deg 0)`.",
       [](Window& w) { w.viewport().take(Tool::turn); }},
      {"Picture", "Scale selection", "", "Scales the selection with the pointer: `set ball.scale (2 2 2)`.",
       [](Window& w) { w.viewport().take(Tool::scale); }},
      {"Picture", "Auto-key", "",
       "Every change in the picture writes an event at the playhead: `at 24f ball.position (1 2 3)`.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::auto_key); },
       [](const Window& w) { return w.viewport().switches().auto_key; }},
      {"Picture", "Ways", "", "Shows the motion paths of the selection.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::trails); },
       [](const Window& w) { return w.viewport().switches().trails; }},
      {"Picture", "Onion skin", "", "Shows the objects some frames before and after.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::ghosts); },
       [](const Window& w) { return w.viewport().switches().ghosts; }},
      {"Picture", "Grid", "", "Shows a grid on the ground.",
       [](Window& w) { w.viewport().flip(&ViewportSwitches::grid); },
       [](const Window& w) { return w.viewport().switches().grid; }},
      {"View", "Find a command…", "Ctrl+Shift+P; F3", "Finds a command by a few of its letters.",
       [](Window& w) { w.find_command(); }},
      {"View", "Larger text", "Ctrl++; Ctrl+=", "Makes all text and controls larger.",
       [](Window& w) { w.set_text_size(w.text_size() * 1.1); }},
      {"View", "Smaller text", "Ctrl+-", "Makes all text and controls smaller.",
       [](Window& w) { w.set_text_size(w.text_size() / 1.1); }},
      {"View", "Normal text", "Ctrl+0", "Gives all text its first size.", [](Window& w) { w.set_text_size(1); }},
      {"View", "Light colours", "", "Switches between light and dark colours.",
       [](Window& w) { w.set_light(!w.is_light()); }, [](const Window& w) { return w.is_light(); }},
      {"View", "Go to console", "Ctrl+Return; F4", "The console runs lines of the language.",
       [](Window& w) { w.show_panel("console"); }},
      {"View", "Go to script", "Ctrl+E", "Shows the text of the film.",
       [](Window& w) { w.show_panel("script_panel"); }},
      {"View", "Go to picture", "Ctrl+1", "Shows the film; you can move objects in it.",
       [](Window& w) { w.show_panel("viewport"); }},
      {"View", "Go to sheet", "Ctrl+2", "Shows events against time.", [](Window& w) { w.show_panel("sheet"); }},
      {"View", "Go to curves", "Ctrl+3", "Shows values against time.", [](Window& w) { w.show_panel("curves"); }},
      {"View", "Go to properties", "Ctrl+4", "Shows the values of the selection.",
       [](Window& w) { w.show_panel("properties"); }},
      {"View", "Go to history", "Ctrl+H", "Lists all steps; a click goes back or forward to one.",
       [](Window& w) { w.show_panel("history"); }},
      {"View", "Go to assets", "", "Shows the files of the film's folder, and materials and colours.",
       [](Window& w) { w.show_panel("assets"); }},
      {"View", "Go to data", "", "Shows the tables of the film.", [](Window& w) { w.show_panel("data"); }},
      {"View", "Go to live controls", "Ctrl+5", "Receives OSC and MIDI, and connects them to targets.",
       [](Window& w) { w.show_panel("live"); }},
      {"View", "Go to server", "Ctrl+6", "Watches and controls a running imaging server.",
       [](Window& w) { w.show_panel("server"); }},
      {"Help", "Course", "", "Five exercises that show you how to animate, step by step.",
       [](Window& w) { w.show_panel("course"); }},
      {"Help", "All keys", "F1", "Lists all keys; you can search, print and change them.",
       [](Window& w) { w.show_keys(); }},
      {"Help", "Manual", "", "The pages about the studio and the language.", [](Window& w) { w.show_manual(); }},
      {"Help", "About Betwixt", "", "The version and the licence.", [](Window& w) { w.show_about(); }},
  };
  std::vector<ActionRow> objects = object_rows();
  for (std::vector<ActionRow> more : {animation_rows(), key_rows()})
    for (ActionRow& row : more) objects.push_back(std::move(row));
  for (const auto& [name, words] : other_words)
    for (std::vector<ActionRow>* rows : {&all, &objects})
      for (ActionRow& row : *rows)
        if (row.name == name) row.also = words;
  for (const ActionRow& row : picture_rows()) {  // each at the end of its menu
    const auto is_of_menu = [&](const ActionRow& r) { return r.menu == row.menu; };
    all.insert(std::find_if(all.rbegin(), all.rend(), is_of_menu).base(), row);
  }
  all.insert(std::ranges::find(all, std::string_view("View"), &ActionRow::menu), objects.begin(), objects.end());
  return all;
}

}  // namespace

const std::vector<ActionRow>& action_rows() {
  static const std::vector<ActionRow> all = made_rows();
  return all;
}

}  // namespace betwixt::studio
