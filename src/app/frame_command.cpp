// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/subcommand.h"
#include "base/files.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"

namespace betwixt {
namespace {

struct FrameCall {
  std::string file, at, out;
  PictureCall picture;
  int bits = 8;
  bool keep_old = false, keep_going = false;
};

// Draws it, and writes it as its name says.
Status draw(const FrameCall& call, const Frame& frame, const RenderOptions& options, Renderer& renderer) {
  if (!options.open && call.bits == 8) {
    Picture picture;
    const Status drawn = renderer.render(frame, picture);
    return drawn ? write_png(call.out, picture, !call.keep_old) : drawn;
  }
  DeepPicture picture;
  if (Status drawn = renderer.render(frame, picture); !drawn) return drawn;
  return (options.open ? write_exr : static_cast<Status (*)(const std::string&, const DeepPicture&, bool)>(write_png))(
      call.out, picture, !call.keep_old);
}

int frame(const FrameCall& call) {
  const std::string kind = ending(call.out);
  if (kind != "png" && kind != "exr")
    return complain(
        fail(ErrorCode::range, "one picture is a .png or .exr, not \"" + call.out + "\"", "for films: betwixt render"),
        wrong_call);
  if (kind == "exr" && call.bits != 8)
    return complain(fail(ErrorCode::range, "--bits is for PNG: a channel of OpenEXR is half a float"), wrong_call);
  if (Status s = check_place(call.out, !call.keep_old); !s) return complain(s.error(), wrong_call);
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  const Result<Time> time = read_time(call.at, *document, "--at");
  if (!time) return complain(time.error(), wrong_call);
  RenderOptions options = call.picture.of(*document);
  options.open = kind == "exr";
  options.deep = options.open || call.bits > 8 || document->transparent();
  Result<std::unique_ptr<Renderer>> renderer = make_renderer(options);
  if (!renderer) return complain(renderer.error(), wrong_call);
  const Frame made = Program::compile(*document).frame(*time);
  Findings found;
  add_findings(found, made, call.file);
  if (stopped_by(found, call.keep_going)) return wrong_input;
  Problems().say(found.warnings);
  const Status drawn = draw(call, made, options, **renderer);
  return drawn ? all_done : complain(drawn.error(), wrong_call);
}

const Enlisted enlisted_frame(frame, [](FrameCall& call) -> Subcommand {
  return {.rank = 20,
          .name = "frame",
          .sentence = "makes one picture, a PNG or an OpenEXR",
          .takes = joined({{script_parameter(call.file),
                            {.name = "--at",
                             .value = "TIME",
                             .sentence = "when: 24f, 2.5s, 00:01:02.5",
                             .into = &call.at,
                             .required = true},
                            output_parameter(call.out, "PICTURE", "the picture")},
                           picture_parameters(call.picture),
                           {bits_parameter(call.bits),
                            flag("--no-overwrite", "leave a picture alone that is there already", call.keep_old),
                            keep_going_flag(call.keep_going)}}),
          .example = "betwixt frame examples/bounce.bx --at 24f -o bounce.png"};
});

}  // namespace
}  // namespace betwixt
