// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "app/code_errors.h"
#include "app/command.h"
#include "app/making.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "betwixt/film.h"
#include "betwixt/picture.h"
#include "betwixt/program.h"

namespace betwixt {
namespace {

struct FrameCall {
  std::string file, at, out;
  PictureCall picture;
  ExposureCall exposure;
  int bits = 8, quality = 0;
  ColorCoding colors = ColorCoding::srgb;
  bool keep_old = false, keep_going = false;
};

constexpr int usual_quality = 92;  // of JPEG

bool is_jpeg(const std::string& path) { return ending(path) == "jpg" || ending(path) == "jpeg"; }

Status write(const FrameCall& call, const LinearPicture& light) {
  if (is_jpeg(call.out)) {
    Picture shown;
    to_shown(light, shown);
    return write_jpeg(call.out, shown, call.quality == 0 ? usual_quality : call.quality, !call.keep_old);
  }
  if (ending(call.out) == "exr") return write_exr(call.out, light, !call.keep_old, call.colors);
  if (call.bits > 8 || call.colors != ColorCoding::srgb) return write_png(call.out, light, !call.keep_old, call.colors);
  Picture shown;
  to_shown(light, shown);
  return write_png(call.out, shown, !call.keep_old);
}

// Renders the picture and writes it in the format of its name.
Status draw(const FrameCall& call, const Program& program, Time t, const RenderOptions& options,
            const std::optional<Blur>& exposure, Renderer& renderer) {
  Evaluation evaluation(program);
  evaluation.to(t);
  if (options.linear) {
    LinearPicture light;
    const Status drawn = shown_picture([&] {
      return exposure ? renderer.render_blurred(evaluation, t, *exposure, light) : renderer.render(evaluation, light);
    });
    return drawn ? write(call, light) : drawn;
  }
  Picture picture;
  const Status drawn = shown_picture([&] { return renderer.render(evaluation, picture); });
  if (!drawn) return drawn;
  if (!is_jpeg(call.out)) return write_png(call.out, picture, !call.keep_old);
  return write_jpeg(call.out, picture, call.quality == 0 ? usual_quality : call.quality, !call.keep_old);
}

int frame(FrameCall& call) {
  const bool named = !call.out.empty();
  call.out = output_or(call.out, call.file, "png");
  const Result<Outgoing> outgoing = Outgoing::begin(call.out, "png");
  if (!outgoing) return complain(outgoing.error(), wrong_call);
  const std::string kind = ending(call.out);
  if (kind != "png" && kind != "exr" && !is_jpeg(call.out))
    return complain(fail(ErrorCode::range, "one picture must be a .png, .jpg or .exr, not \"" + call.out + "\"",
                         "to make a film: betwixt render"),
                    wrong_call);
  if (kind != "png" && call.bits != 8)
    return complain(
        fail(ErrorCode::range, kind == "exr" ? "--bits is for PNG; a channel of OpenEXR is always a half float"
                                             : "--bits is for PNG; a channel of JPEG always has 8 bits"),
        wrong_call);
  if (is_jpeg(call.out) && call.colors != ColorCoding::srgb)
    return complain(
        fail(ErrorCode::range, "--colors: JPEG has the colors of sRGB only", ".png and .exr can have others"),
        wrong_call);
  if (kind == "exr" && has_highlights(call.colors))
    return complain(fail(ErrorCode::range, "--colors: OpenEXR has light without limit, not signals",
                         "p3 and rec2020 choose its primaries"),
                    wrong_call);
  if (!is_jpeg(call.out) && call.quality != 0)
    return complain(fail(ErrorCode::range, "--quality is for .jpg; the other formats are lossless"), wrong_call);
  if (Status s = check_place(call.out, !call.keep_old); !s) return complain(s.error(), wrong_call);
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  const Result<Time> time = call.at.empty() ? document->range().first : read_time(call.at, *document, "--at");
  if (!time) return complain(time.error(), wrong_call);
  const Result<std::optional<Blur>> exposure = call.exposure.of(*document);
  if (!exposure) return complain(exposure.error(), wrong_call);
  RenderOptions options = call.picture.of(*document);
  options.unclamped = kind == "exr";
  options.linear =
      options.unclamped || call.bits > 8 || document->transparent() || *exposure || call.colors != ColorCoding::srgb;
  options.peak = has_highlights(call.colors) ? peak_nits / white_nits : 1;
  Result<std::unique_ptr<Renderer>> renderer = make_renderer(options);
  if (!renderer) return complain(renderer.error(), wrong_call);
  const Program program = Program::compile(*document);
  const Frame made = program.frame(*time);
  Findings found;
  add_findings(found, made, call.file);
  if (stopped_by(found, call.keep_going)) return wrong_input;
  if (document->transparent() && is_jpeg(call.out)) say_not_clear(call.out);
  Problems().say(found.warnings);
  const Status drawn = draw(call, program, *time, options, *exposure, **renderer);
  if (!drawn) return complain(drawn.error(), wrong_call);
  if (const Status sent = outgoing->send(); !sent) return complain(sent.error(), machine_failed);
  if (!named && !*outgoing) tell_user(call.out + "\n");
  return all_done;
}

const Enlisted enlisted_frame(frame, [](FrameCall& call) -> Subcommand {
  return {.rank = 20,
          .name = "frame",
          .sentence = "makes one picture: PNG, JPEG or OpenEXR",
          .takes = joined(
              {{script_parameter(call.file),
                {.name = "--at",
                 .value = "TIME",
                 .sentence = "the time: 24f, 2.5s, 00:01:02.5; by default the film's first frame",
                 .into = &call.at},
                output_parameter(call.out, "PICTURE",
                                 "the picture: .png .jpg .exr; - is standard output, -.jpg a JPEG there", "png")},
               picture_parameters(call.picture),
               exposure_parameters(call.exposure),
               {bits_parameter(call.bits), colors_parameter(call.colors),
                quality_parameter(call.quality, "the quality of JPEG; by default 92"),
                flag("--no-overwrite", "keeps an existing file", call.keep_old), keep_going_flag(call.keep_going)}}),
          .example = "betwixt frame examples/bounce.bx --at 24f -o bounce.png"};
});

}  // namespace
}  // namespace betwixt
