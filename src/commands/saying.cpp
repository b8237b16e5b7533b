// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Sounds that say a text: create voice sound say="A square stands on a line." voice="en-us" pace=150
#include "base/cancellation.h"
#include "commands/furnishing.h"
#include "exchange/said_text.h"
#include "language/values.h"
#include "scene/memory.h"

namespace betwixt {

bool said_parameter(Command& k, std::string_view key, Furniture& out) {
  if (key != "say" && key != "voice" && key != "pace") return false;
  Cursor& c = k.cursor;
  SayText& say = out.say ? *out.say : out.say.emplace();
  c.space();
  const char* const start = c.at;
  if (key == "pace") {
    double pace = 0;
    if (!c.number(pace)) return false;
    if (!(pace >= slowest_pace && pace <= fastest_pace) || pace != static_cast<int>(pace))
      return c.fail(ErrorCode::range, "a pace is a whole number from 80 to 450 words a minute", c.since(start));
    say.pace = static_cast<int>(pace);
    return true;
  }
  if (c.peek() != '"')
    return c.fail_here(ErrorCode::syntax, "a text in quotes is missing here",
                       key == "say" ? "as in say=\"Hello\"" : "as in voice=\"en-us\"");
  if (!c.text(key == "say" ? say.text : say.voice)) return false;
  // Words of the error point here.
  (key == "say" ? out.say_at : out.voice_at) = c.since(start);
  return true;
}

bool load_said_text(Command& k, const std::string& name, std::string_view voice_at, std::string_view about) {
  Scene& s = k.scene;
  if (s.sounds->contains(name) && s.words->contains(name)) return true;
  Cancellation::check();
  const auto said = say_named(name);
  if (!said) return k.cursor.fail(said.error(), said.error().code == ErrorCode::name ? voice_at : about);
  const std::shared_ptr<const Sound> sound(*said, (*said)->sound.get());  // keeps its file
  ContentBytes bytes;
  bytes.add(sound), bytes.add((*said)->words);
  if (!has_room(k, bytes, about)) return false;
  s.sounds.edit()[name] = sound, s.words.edit()[name] = (*said)->words;
  return true;
}

bool give_said_text(Command& k, Object& object, const Furniture& said, std::string_view about) {
  Cursor& c = k.cursor;
  if (said.say_at.empty()) return c.fail(ErrorCode::syntax, "the text to say is missing", about, "as in say=\"Hello\"");
  if (object.find(fn::sound_file))
    return c.fail(ErrorCode::syntax, "a sound has a file, or says a text", said.say_at,
                  "leave out say= once there is a recording");
  if (object.find(fn::sound_words))
    return c.fail(ErrorCode::syntax, "what is said has its words already", said.say_at, "leave out words=");
  std::string name = said_name(*said.say);
  if (!load_said_text(k, name, said.voice_at.empty() ? said.say_at : said.voice_at, said.say_at)) return false;
  object.slot(fn::sound_file).set = Value(Text(std::move(name)));
  return true;
}

}  // namespace betwixt
