// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Which words begin a command.
#include <algorithm>

#include "language/reader.h"

namespace betwixt {

const std::vector<Reader::Verb>& Reader::verbs() {
  static const std::vector<Verb> table{
      {"rate", "rate N, as in rate 24 or rate 30000/1001", &Reader::rate},
      {"range", "range FROM TO, as in range 1f 48f", &Reader::range},
      {"ticks", "ticks N [smooth], environment ticks per second", &Reader::ticks},
      {"background", "background COLOR", &Reader::background},
      {"create", "create NAME KIND [key=value …] or create NAME like OTHER", &Reader::create},
      {"remove", "remove NAME", &Reader::remove},
      {"rename", "rename OLD NEW, an object or a display list", &Reader::rename},
      {"set", "set TARGET VALUE, as in set ball.color red", &Reader::set},
      {"at", "at TIME TARGET VALUE or at TIME COMMAND", &Reader::at},
      {"couple", "couple A to B [keep-world]", &Reader::couple},
      {"attach", "attach A to B [keep-world]", &Reader::attach},
      {"hang", "hang A on B [keep-world]", &Reader::hang},
      {"detach", "detach A", &Reader::detach},
      {"letgo", "at TIME letgo A", &Reader::letgo},
      {"look", "at TIME look through CAMERA", &Reader::look},
      {"note", "at TIME note \"…\"", &Reader::note_command},
      {"notes", "notes on or notes off", &Reader::notes},
      {"show", "show A or at TIME show A", &Reader::show},
      {"hide", "hide A or at TIME hide A", &Reader::hide},
      {"twerper", "twerper TARGET NAME [in=light|srgb]; none gives every event its own again", &Reader::global_twerper},
      {"extend", "extend TARGET hold|linear|cycle|bounce [before|after]", &Reader::extend},
      {"copy", "copy TARGET A..B to T [on TARGET] [shift V] [times N]", &Reader::copy},
      {"move", "move TARGET A..B by LENGTH", &Reader::move},
      {"stretch", "stretch TARGET A..B by FACTOR", &Reader::stretch},
      {"reverse", "reverse TARGET A..B", &Reader::reverse},
      {"scale", "scale TARGET A..B (X Y Z)", &Reader::scale},
      {"translate", "translate TARGET A..B (X Y Z)", &Reader::translate},
      {"rotate", "rotate TARGET A..B ANGLE AXIS [@ (X Y Z)]", &Reader::rotate},
      {"clear", "clear TARGET A..B or clear TARGET TIME", &Reader::clear},
      {"stagger", "stagger TARGETS by LENGTH [random N]", &Reader::stagger},
      {"spread", "spread TARGETS from VALUE to VALUE", &Reader::spread},
      {"alias", "alias NAME = ELEMENT …", &Reader::alias},
      {"define", "define NAME TYPE [default]", &Reader::define},
      {"layer", "layer NAME add|mix [weight=W]", &Reader::layer},
      {"on", "on LAYER COMMAND, or on LAYER TARGET to open a sheet", &Reader::on_layer},
      {"filter", "filter TARGET NAME [key=value …] [A..B]; filter TARGET none", &Reader::filter},
      {"procedure", "procedure NAME [twerper|filter|command] lua \"…\"", &Reader::procedure},
      {"fall", "at TIME fall A [delay=L] [gravity=G] [ground=Y] [bounce=K] [for L]", &Reader::fall},
      {"dial", "dial ADDRESS to TARGET [from A B to C D]", &Reader::dial},
      {"record", "record on or record off", &Reader::record},
      {"animate", "animate ENV every L by TRANSFORM [slower|faster L per L] [limit L] [from L] [until L] [keep-phase]",
       &Reader::animate},
      {"halt", "at TIME halt ENV", &Reader::halt},
      {"kill", "at TIME kill ENV", &Reader::kill},
      {"cancel", "at TIME cancel ENV", &Reader::cancel},
      {"make", "[at TIME] make NAME; the commands of the display list are rows below it", &Reader::make_list},
      {"edit", "[at TIME] edit NAME; rows below it go on the end, or behind replace TAG in place of others",
       &Reader::edit_list},
      {"delete", "[at TIME] delete NAME, a display list", &Reader::delete_list},
      {"start", "start NAME, a display list", &Reader::start_list},
      {"policy", "policy translate|ignore|ask", &Reader::policy},
      {"use", "use FILE", &Reader::use},
  };
  return table;
}

std::vector<std::pair<std::string_view, std::string_view>> Reader::words() {
  std::vector<std::pair<std::string_view, std::string_view>> all;
  for (const Verb& v : verbs()) all.emplace_back(v.word, v.usage);
  return all;
}

std::string_view Reader::not_yet(std::string_view verb) {
  static constexpr std::string_view shell[] = {"help", "list", "describe", "undo", "redo", "plot",
                                               "play", "stop", "save",     "open", "load", "quit"};
  if (verb == "load") return "is no word of a script: plug-ins are programs, which a script must not start";
  if (std::find(std::begin(shell), std::end(shell), verb) != std::end(shell))
    return "is a word of the shell; a script does not need it";
  return {};
}

}  // namespace betwixt
