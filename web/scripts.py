# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The scripts of pages, in their order: those around the engine, and those of the player and the editor.
engine_scripts = ("algebra.js", "sounds.js", "engine.js")
player_scripts = ("base64.js", "dom.js", "player_look.js", "player_face.js", "player_attributes.js",
                  "player_source.js", "player_loader.js", "player_clock.js", "player_picture.js",
                  "player_sound.js", "player_controls.js", "player_voice.js", "player_loop.js", "player.js")
editor_scripts = ("editor.js",)
