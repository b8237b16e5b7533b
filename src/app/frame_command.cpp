// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/subcommand.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"

namespace betwixt {
namespace {

struct FrameCall {
  std::string file, at, out;
  PictureCall picture;
  ExposureCall exposure;
  int bits = 8;
  bool keep_old = false, keep_going = false;
};

Status write(const FrameCall& call, const DeepPicture& light) {
  if (ending(call.out) == "exr") return write_exr(call.out, light, !call.keep_old);
  if (call.bits > 8) return write_png(call.out, light, !call.keep_old);
  Picture shown;
  to_shown(light, shown);
  return write_png(call.out, shown, !call.keep_old);
}

// Draws it, and writes it as its name says.
Status draw(const FrameCall& call, const Program& program, Time t, const RenderOptions& options,
            const std::optional<Exposure>& exposure, Renderer& renderer) {
  Evaluation evaluation(program);
  evaluation.to(t);
  if (options.deep) {
    DeepPicture light;
    const Status drawn =
        exposure ? renderer.expose(evaluation, t, *exposure, light) : renderer.render(evaluation, light);
    return drawn ? write(call, light) : drawn;
  }
  Picture picture;
  const Status drawn = renderer.render(evaluation, picture);
  return drawn ? write_png(call.out, picture, !call.keep_old) : drawn;
}

int frame(FrameCall& call) {
  const bool named = !call.out.empty();
  call.out = output_or(call.out, call.file, "png");
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
  const Result<Time> time = call.at.empty() ? document->range().first : read_time(call.at, *document, "--at");
  if (!time) return complain(time.error(), wrong_call);
  const Result<std::optional<Exposure>> exposure = call.exposure.of(*document);
  if (!exposure) return complain(exposure.error(), wrong_call);
  RenderOptions options = call.picture.of(*document);
  options.open = kind == "exr";
  options.deep = options.open || call.bits > 8 || document->transparent() || *exposure;
  Result<std::unique_ptr<Renderer>> renderer = make_renderer(options);
  if (!renderer) return complain(renderer.error(), wrong_call);
  const Program program = Program::compile(*document);
  const Frame made = program.frame(*time);
  Findings found;
  add_findings(found, made, call.file);
  if (stopped_by(found, call.keep_going)) return wrong_input;
  Problems().say(found.warnings);
  const Status drawn = draw(call, program, *time, options, *exposure, **renderer);
  if (!drawn) return complain(drawn.error(), wrong_call);
  if (!named) tell_user(call.out + "\n");
  return all_done;
}

const Enlisted enlisted_frame(frame, [](FrameCall& call) -> Subcommand {
  return {.rank = 20,
          .name = "frame",
          .sentence = "makes one picture, a PNG or an OpenEXR",
          .takes = joined({{script_parameter(call.file),
                            {.name = "--at",
                             .value = "TIME",
                             .sentence = "when: 24f, 2.5s, 00:01:02.5; usually the film's first frame",
                             .into = &call.at},
                            output_parameter(call.out, "PICTURE", "the picture", "png")},
                           picture_parameters(call.picture),
                           exposure_parameters(call.exposure),
                           {bits_parameter(call.bits),
                            flag("--no-overwrite", "leave a picture alone that is there already", call.keep_old),
                            keep_going_flag(call.keep_going)}}),
          .example = "betwixt frame examples/bounce.bx --at 24f -o bounce.png"};
});

}  // namespace
}  // namespace betwixt
