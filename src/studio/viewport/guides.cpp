// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/viewport/guides.h"

#include <QFileInfo>
#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "language/values.h"

namespace betwixt::studio {
namespace {

constexpr qsizetype most_films = 50;  // whose guides are kept

QString path_of(const std::string& file) { return QFileInfo(QString::fromStdString(file)).absoluteFilePath(); }

// A row of the settings: the path of a film, and its guides, each after a tab.
QStringList kept_rows() { return QSettings("betwixt", "studio").value("guides").toStringList(); }

}  // namespace

QString in_words(const Guide& g) { return QString("%1 %2").arg("xyz"[g.axis]).arg(write_number(g.at).c_str()); }

std::optional<Guide> guide_of(const QString& words) {
  const QStringList parts = words.simplified().replace('=', ' ').simplified().split(' ');
  if (parts.size() != 2 || parts[0].size() != 1) return std::nullopt;
  const qsizetype axis = QString("xyz").indexOf(parts[0].toLower());
  bool good = false;
  const double at = parts[1].toDouble(&good);
  return axis >= 0 && good && std::isfinite(at) ? std::optional(Guide{static_cast<int>(axis), at}) : std::nullopt;
}

Guides with_or_without(Guides all, const Guide& g) {
  if (std::erase(all, g) == 0) all.push_back(g);
  return all;
}

std::optional<std::pair<int, int>> axes_of(const Projection& view) {
  if (!view.orthographic()) return std::nullopt;
  const auto axis_along = [](Vec3 v) {
    for (int i = 0; i < 3; ++i)
      if (std::abs(std::abs(v[i]) - 1) < 1e-6) return i;
    return -1;
  };
  const int right = axis_along(view.right()), up = axis_along(view.up());
  return right < 0 || up < 0 ? std::nullopt : std::optional(std::pair(right, up));
}

Guides kept_guides(const std::string& file) {
  Guides all;
  if (file.empty()) return all;
  for (const QString& row : kept_rows()) {
    const QStringList parts = row.split('\t');
    if (parts[0] != path_of(file)) continue;
    for (const QString& words : parts.mid(1))
      if (const auto g = guide_of(words)) all.push_back(*g);
  }
  return all;
}

void keep_guides(const std::string& file, const Guides& all) {
  if (file.empty() || all == kept_guides(file)) return;
  QStringList rows = kept_rows();
  rows.removeIf([&](const QString& row) { return row.section('\t', 0, 0) == path_of(file); });
  QString row = path_of(file);
  for (const Guide& g : all) row += '\t' + in_words(g);
  if (!all.empty()) rows.prepend(row);
  QSettings("betwixt", "studio").setValue("guides", rows.mid(0, most_films));
}

}  // namespace betwixt::studio
