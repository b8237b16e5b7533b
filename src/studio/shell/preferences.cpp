// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/preferences.h"

#include <QSettings>
#include <algorithm>

#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

// Returns the value in the form of the row, or nothing if it does not fit. Files hold all values as text.
std::optional<QVariant> fitting(const Preference& row, const QVariant& value) {
  switch (row.kind) {
    case Preference::Kind::on_off: {
      const QString word = value.toString();
      if (word != "true" && word != "false") return std::nullopt;
      return word == "true";
    }
    case Preference::Kind::choice:
      if (std::ranges::none_of(row.choices, [&](const auto& c) { return text_of(c.first) == value.toString(); }))
        return std::nullopt;
      return value.toString();
    case Preference::Kind::percent: {
      bool is = false;
      const int number = value.toInt(&is);
      if (!is) return std::nullopt;
      return std::clamp(number, row.low, row.high);
    }
    case Preference::Kind::fact:
      break;
  }
  return std::nullopt;
}

}  // namespace

const std::vector<Preference>& preference_rows() {
  using enum Preference::Kind;
  static const std::vector<Preference> all = {
      {"language",
       "General",
       QT_TR_NOOP("Language"),
       QT_TR_NOOP("The language of the studio. The language of scripts is the same everywhere."),
       choice,
       "system",
       {{"system", QT_TR_NOOP("as the system")}, {"en", "English"}, {"de", "Deutsch"}, {"fr", "Français"}}},
      {"start",
       "General",
       QT_TR_NOOP("At the start"),
       QT_TR_NOOP("What the studio opens if you name no film."),
       choice,
       "example",
       {{"example", QT_TR_NOOP("an example")},
        {"last", QT_TR_NOOP("the last film")},
        {"empty", QT_TR_NOOP("an empty film")}}},
      {"earlier",
       "General",
       QT_TR_NOOP("Unsaved work after a crash"),
       QT_TR_NOOP("What happens to steps that were not saved when the studio ended last time."),
       choice,
       "ask",
       {{"ask", QT_TR_NOOP("show the difference and ask")},
        {"recover", QT_TR_NOOP("recover it")},
        {"discard", QT_TR_NOOP("discard it")}}},
      {"fact-journal",
       "General",
       QT_TR_NOOP("Safety"),
       QT_TR_NOOP("Every step is written to the journal beside the script before you see it. Undo has no limit."),
       fact,
       {}},
      {"light", "Appearance", QT_TR_NOOP("Light colours"), QT_TR_NOOP("Light colours instead of dark ones."), on_off,
       false},
      {"interface-size",
       "Appearance",
       QT_TR_NOOP("Size of text and controls"),
       QT_TR_NOOP("All text, and all controls with it; also ctrl-plus and ctrl-minus."),
       percent,
       100,
       {},
       70,
       250},
      {"script-size",
       "Appearance",
       QT_TR_NOOP("Size of the script"),
       QT_TR_NOOP("The text of the script and the console, beside the size of all text."),
       percent,
       100,
       {},
       70,
       250},
      {"safe-colors", "Appearance", QT_TR_NOOP("Colours for colour-blind eyes"),
       QT_TR_NOOP("Axes, curves, marks and motion paths get colours that differ also for colour-blind eyes."), on_off,
       false},
      {"less-motion", "Appearance", QT_TR_NOOP("Less motion"),
       QT_TR_NOOP("Cursors do not blink, and panels and menus do not glide or fade."), on_off, false},
      {"loop", "Playback", QT_TR_NOOP("Loop"), QT_TR_NOOP("Films begin again at their end."), on_off, true},
      {"mute", "Playback", QT_TR_NOOP("Without sound"), QT_TR_NOOP("Films play without their sound."), on_off, false},
  };
  return all;
}

const Preference* preference(std::string_view name) {
  const auto found = std::ranges::find(preference_rows(), name, &Preference::name);
  return found == preference_rows().end() ? nullptr : &*found;
}

Preferences& Preferences::of_user() {
  static Preferences preferences;
  return preferences;
}

QVariant Preferences::value(std::string_view name) const {
  const auto own = std::ranges::find(own_, text_of(name), &std::pair<QString, QVariant>::first);
  if (own != own_.end()) return own->second;
  const Preference* row = preference(name);
  return row ? row->initial : QVariant();
}

void Preferences::set(std::string_view name, const QVariant& wanted) {
  const Preference* row = preference(name);
  const auto value = row ? fitting(*row, wanted) : std::nullopt;
  if (!value || *value == this->value(name)) return;
  const QString key = text_of(name);
  std::erase_if(own_, [&](const auto& own) { return own.first == key; });
  const bool differs = *value != row->initial;
  if (differs) own_.emplace_back(key, *value);
  if (remembers_) {
    QSettings settings("betwixt", "studio");
    differs ? settings.setValue(key, *value) : settings.remove(key);
  }
  emit changed(key);
}

void Preferences::reset_all() {
  for (const Preference& row : preference_rows()) set(row.name, row.initial);
}

void Preferences::recall() {
  remembers_ = false;
  QSettings settings("betwixt", "studio");
  for (const Preference& row : preference_rows()) {
    const auto kept =
        settings.contains(text_of(row.name)) ? fitting(row, settings.value(text_of(row.name))) : std::nullopt;
    set(row.name, kept.value_or(row.initial));
  }
  remembers_ = true;
}

}  // namespace betwixt::studio
