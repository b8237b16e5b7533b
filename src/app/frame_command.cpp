// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/command.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"
#include "film/output.h"

namespace betwixt {
namespace {

struct Call {
  std::string file, at, out;
  RenderOptions picture;
  bool keep_old = false;
};

int frame(const Call& call) {
  if (!call.out.ends_with(".png") && !call.out.ends_with(".PNG"))
    return complain(fail(Code::range, "one picture is a .png, not \"" + call.out + "\"", "for films: betwixt render"),
                    wrong_call);
  if (Status s = check_place(call.out, !call.keep_old); !s) return complain(s.error(), wrong_call);
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  const Result<Time> time = read_time(call.at, *document, "--at");
  if (!time) return complain(time.error(), wrong_call);
  Result<std::unique_ptr<Renderer>> renderer = make_renderer(call.picture);
  if (!renderer) return complain(renderer.error(), wrong_call);
  Picture picture;
  const Frame made = Program::compile(*document).frame(*time);
  Problems().say(made.problems);
  if (Status s = (*renderer)->render(made, picture); !s) return complain(s.error(), wrong_input);
  if (Status s = write_png(call.out, picture, !call.keep_old); !s) return complain(s.error(), wrong_call);
  return all_done;
}

}  // namespace

void add_frame(CLI::App& app, int& exit_code) {
  const auto call = std::make_shared<Call>();
  CLI::App* sub = app.add_subcommand("frame", "makes one picture, a PNG");
  sub->add_option("FILE", call->file, "the script")->required()->type_name("");
  sub->add_option("--at", call->at, "when: 24f, 2.5s, 00:01:02.5")->required()->type_name("TIME");
  sub->add_option("-o,--output", call->out, "the picture")->required()->type_name("PICTURE");
  add_picture_options(*sub, call->picture);
  sub->add_flag("--no-overwrite", call->keep_old, "leave a picture alone that is there already");
  sub->footer("Example:\n  betwixt frame examples/bounce.bx --at 24f -o bounce.png");
  sub->callback([call, &exit_code] { exit_code = frame(*call); });
}

}  // namespace betwixt
