// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests renderers of plug-ins: they get the frame, and what goes wrong in them is told and stays in their process.
#include "render/plugin_renderer.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "render/scenes.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

const std::string plugin = PLUGIN_DIR "/pictures.so";

RenderOptions in_style(const std::string& style) { return {12, 10, 1, style}; }

// Runs a test in a process of its own, so that other tests do not find the plug-in's styles.
template <class Body>
void apart(Body body) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    body();
    std::fflush(stdout);
    ::_exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

Status drawn(Renderer& renderer, const Frame& frame, Picture& out) { return renderer.render(frame, out); }

void get_the_frame() {
  ASSERT_TRUE(use_plugin(plugin));
  const LoadedFilm film(
      "background rgb(0 1 0)\ncreate eye camera position=(0 0 20)\ncreate lamp light\n"
      "create a box size=(3 2 1) position=(2 4 0) color=red transparency=0.6\n"
      "create b box size=(3 2 1) position=(7 1 0) scale=(2 1 1)\ncreate c sphere display=off\n");
  const auto renderer = make_renderer(in_style("probe"));
  ASSERT_TRUE(renderer) << renderer.error().message;
  Picture p;
  ASSERT_TRUE(drawn(**renderer, film.frame("1f"), p));
  using scenes::Pixel;
  EXPECT_EQ(scenes::pixel(p, 0, 0), (Pixel{2, 1, 0, 1}));
  EXPECT_EQ(scenes::pixel(p, 1, 0), (Pixel{12, 10, 255, 255}));
  EXPECT_EQ(scenes::pixel(p, 2, 0), (Pixel{255, 0, 0, 102}));
  const auto width_of = [&](int x) { return scenes::pixel(p, x, 0).g / 10.0; };
  // Mesh space may be scaled: the world matrix times the mesh is as wide as the box.
  EXPECT_EQ(scenes::pixel(p, 3, 0).r, 20);
  EXPECT_EQ(scenes::pixel(p, 3, 0).g, 40);
  EXPECT_NEAR(scenes::pixel(p, 3, 0).b / 10.0 * width_of(4), 3, 0.2);
  EXPECT_EQ(scenes::pixel(p, 3, 0).a, 0) << "a triangle has a vertex outside its mesh";
  EXPECT_EQ(scenes::pixel(p, 4, 0).r, 12) << "a box has twelve triangles";
  EXPECT_EQ(scenes::pixel(p, 6, 0).r, 70);
  EXPECT_NEAR(scenes::pixel(p, 6, 0).b / 10.0 * width_of(7), 6, 0.3);
  EXPECT_EQ(scenes::pixel(p, 7, 0).b, scenes::pixel(p, 4, 0).b) << "equal boxes share a mesh";
  // The process goes on from picture to picture, and an evaluation gives the same.
  Evaluation e(film.program);
  e.to(*parse_time("1f", film.loaded.document));
  Picture again;
  ASSERT_TRUE((*renderer)->render(e, again));
  EXPECT_EQ(scenes::pixel(again, 0, 0), (Pixel{2, 1, 0, 2}));
  EXPECT_TRUE(std::equal(again.rgba.begin() + 4, again.rgba.end(), p.rgba.begin() + 4));
  // A frame that needs more memory comes too.
  std::string many = "create s{1..3000} text text=\"betwixt\" position=(i 0 0)\n";
  Picture large;
  EXPECT_TRUE(drawn(**renderer, LoadedFilm(many).frame("1f"), large));
}

void tell_faults() {
  ASSERT_TRUE(use_plugin(plugin));
  const Frame one = LoadedFilm("create a box\n").frame("1f"),
              two = LoadedFilm("create a box\ncreate b box\n").frame("1f");
  Picture p;
  const auto crashing = make_renderer(in_style("crashes"));
  for (int times = 0; times < 3; ++times) {
    EXPECT_TRUE(drawn(**crashing, one, p));
    EXPECT_EQ(scenes::pixel(p, 0, 0).r, 77);
    const Status bad = drawn(**crashing, two, p);
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().code, ErrorCode::machine);
    EXPECT_EQ(bad.error().message, "the renderer 'crashes' of " + plugin + " has crashed");
  }
  const auto failing = make_renderer(in_style("fails"));
  EXPECT_EQ(drawn(**failing, one, p).error().message,
            "the renderer 'fails' of " + plugin + " failed: it does not like this picture");
  const auto endless = make_plugin_renderer(in_style("endless"), 100);
  EXPECT_EQ(drawn(**endless, one, p).error().message,
            "the renderer 'endless' of " + plugin + " takes more than 0.1 seconds for a picture");
  EXPECT_EQ(make_renderer(in_style("prob")).error().hint, "probe");
  EXPECT_EQ(make_plugin_renderer(in_style("nothing")).error().code, ErrorCode::name);
}

void are_styles() {
  const std::vector<Style>& before = styles();
  ASSERT_TRUE(use_plugin(plugin));
  EXPECT_FALSE(before.empty());
  const std::vector<Style>& all = styles();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const Style& s) { return s.name == "probe" && s.what == "shows what it is given"; }));
  RenderOptions options = in_style("crashes");
  options.linear = true;
  LinearPicture light;
  const auto renderer = make_renderer(options);
  ASSERT_TRUE((*renderer)->render(LoadedFilm("create a box\n").frame("1f"), light));
  EXPECT_NEAR(light.rgba[0], scenes::decoded(77 / 255.0), 1e-6);
  EXPECT_NEAR(light.rgba[3], 77 / 255.0, 1e-6);
}

// shows: G14 S6
TEST(PluginRenderers, GetTheFrameAsColumns) { apart(get_the_frame); }
TEST(PluginRenderers, TheirFaultsAreTold) { apart(tell_faults); }
TEST(PluginRenderers, AreStylesLikeOthers) { apart(are_styles); }

}  // namespace
}  // namespace betwixt
