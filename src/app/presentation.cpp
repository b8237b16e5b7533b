// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/presentation.h"

#include <algorithm>
#include <filesystem>

#include "app/command.h"
#include "base/files.h"
#include "film/pdf.h"
#include "playback/film_player.h"

namespace betwixt {

std::vector<Pause> stops_of(const Document& document, const FrameList& frames) {
  const Time first = frames.time(0), last = frames.time(frames.count - 1);
  std::vector<Pause> all;
  for (Pause& pause : document.pauses())
    if (pause.time >= first && pause.time <= std::max(last, frames.last)) all.push_back(std::move(pause));
  if (all.empty() || all.front().time > first) all.insert(all.begin(), Pause{first, {}, {}});
  if (all.back().time < last) all.push_back({last, {}, {}});
  return all;
}

Result<int> write_steps_as_pdf(const Program& program, const FrameList& frames, const RenderOptions& options,
                               int quality, const std::string& path, bool overwrite) {
  if (Status s = check_place(path, overwrite); !s) return s.error();
  PdfPages pdf;
  FilmPlayer film;
  Picture picture;
  int pages = 0;
  for (const Pause& pause : program.document().pauses()) {
    if (pause.time < frames.time(0) || pause.time > std::max(frames.last, frames.time(frames.count - 1))) continue;
    film.evaluate(program, pause.time);
    if (Status s = film.draw(options, picture); !s) return s.error();
    if (Status s = pdf.add(picture, quality > 0 ? quality : 92, pause.text); !s) return s.error();
    ++pages;
  }
  if (pages == 0)
    return fail(ErrorCode::range, "this film has no steps, so the PDF would have no page",
                "write where a speaker waits: at 24f step \"The proof\"");
  const std::string title = std::filesystem::path(path).stem().string();
  if (Status s = write_whole(path, pdf.document(title), overwrite); !s) return s.error();
  return pages;
}

}  // namespace betwixt
