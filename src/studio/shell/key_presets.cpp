// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The presets of keys: what people press who come from other programs. Each is a list of differences.
#include "studio/shell/keys.h"

namespace betwixt::studio {

const std::vector<KeyPreset>& key_presets() {
  static const std::vector<KeyPreset> all = {
      {"betwixt", "Betwixt", {}},
      {"blender",
       "Blender",
       {{"everywhere", "Insert position, rotation and scale", "I"},
        {"everywhere", "Add object", "Shift+A"},
        {"everywhere", "Play backwards", "Ctrl+Shift+Space"},
        {"everywhere", "Go to start", "Shift+Left"},
        {"everywhere", "Go to end", "Shift+Right"},
        {"everywhere", "Set play range start", "Ctrl+Home"},
        {"everywhere", "Set play range end", "Ctrl+End"},
        {"everywhere", "Clear play range", "Alt+P"},
        {"everywhere", "Render film…", "F12; Ctrl+F12"},
        {"everywhere", "Find a command…", "F3; Ctrl+Shift+P"},
        {"everywhere", "Redo", "Ctrl+Shift+Z"},
        {"picture", "Frame selection", "."},
        {"picture", "Opposite view", "9; Ctrl+1"},
        {"picture", "Select nothing", "Alt+A"},
        {"objects", "Duplicate", "Shift+D"},
        {"objects", "Remove", "X; Del"},
        {"objects", "Remove with all below", "Shift+X; Shift+Del"},
        {"objects", "Ungroup", "Ctrl+Alt+G"},
        {"events", "Delete events", "X; Del"},
        {"events", "Duplicate after it", "Shift+D"},
        {"sheet", "Select all events", "A"},
        {"sheet", "Show all times", "Home"},
        {"curves", "Show all values", ""},
        {"curves", "Select all points", "A"}}},
      {"after-effects",
       "After Effects",
       {{"everywhere", "Insert event at playhead", "Alt+Shift+P"},
        {"everywhere", "Next frame", "PgDown; Ctrl+Right"},
        {"everywhere", "Previous frame", "PgUp; Ctrl+Left"},
        {"everywhere", "Set play range start", "B"},
        {"everywhere", "Set play range end", "N"},
        {"everywhere", "Clear play range", ""},
        {"everywhere", "Render film…", "Ctrl+M"},
        {"everywhere", "Mute", "Ctrl+Alt+M"},
        {"everywhere", "Go to curves", "Shift+F3; Ctrl+3"},
        {"everywhere", "New", "Ctrl+Alt+N; Ctrl+N"},
        {"everywhere", "Preferences…", "Ctrl+Alt+;; Ctrl+,"},
        {"picture", "Move selection", "P"},
        {"picture", "Handles to move", "V"},
        {"picture", "Handles to turn", "W"},
        {"picture", "Select all", "Ctrl+A"},
        {"picture", "Select nothing", "F2; Ctrl+Shift+A"},
        {"events", "Delete events", "Del; Backspace"},
        {"events", "Move a frame earlier", "Alt+Left"},
        {"events", "Move a frame later", "Alt+Right"},
        {"sheet", "Show all times", "Shift+/; Ctrl+Home"},
        {"curves", "Normalise", "Alt+N"}}},
  };
  return all;
}

}  // namespace betwixt::studio
