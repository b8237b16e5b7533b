// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/plugins.h"

#include <gtest/gtest.h>

#include <fstream>

#include "procedure/fake.h"
#include "support/told.h"

namespace betwixt {
namespace {

std::string at(const std::string& name) { return PLUGIN_DIR "/" + name + ".so"; }
const PluginItem& item(const Plugin& p, std::string_view name) {
  for (const auto& i : p.items)
    if (i.name == name) return i;
  ADD_FAILURE() << name;
  return p.items.front();
}
std::string error(const std::string& path) {
  const auto p = load_plugin(path);
  EXPECT_FALSE(p) << path;
  return p ? "" : p.error().message;
}

// shows: G14 G15 G17 G19 G103
TEST(Plugins, TheExample) {
  const auto p = load_plugin(at("example"));
  ASSERT_TRUE(p) << p.error().message;
  ASSERT_EQ(p->items.size(), 2u);
  const auto& overshoot = item(*p, "overshoot");
  EXPECT_EQ(overshoot.role, Role::twerper);
  EXPECT_EQ(overshoot.help, "goes a tenth beyond the end and comes back");
  EXPECT_EQ(overshoot.code->language, "plug-in");
  EXPECT_NEAR(*overshoot.code->blend(0), 0, 1e-15);
  EXPECT_EQ(*overshoot.code->blend(1), 1);
  double most = 0;
  for (int i = 0; i <= 1000; ++i) most = std::max(most, *overshoot.code->blend(i / 1000.0));
  EXPECT_NEAR(most, 1.1, 1e-4);
  FakeInput in;  // 10 t
  const auto& stairs = *item(*p, "stairs").code;
  EXPECT_EQ(std::get<double>(*stairs.filter(in, 0.161, {})), 1.5);
  EXPECT_EQ(std::get<double>(*stairs.filter(in, 0.161, {{"step", Value(1.0)}})), 2);
  EXPECT_EQ(stairs.filter(in, 0, {{"step", Value(-1.0)}}).error().message, "the step must be more than 0");
  EXPECT_TRUE(mentions(stairs.blend(0), "twerper"));
}

// shows: G14 G15 G19 G54 G55
TEST(Plugins, OneOfEach) {
  const auto p = load_plugin(at("all"));
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_EQ(*item(*p, "power").code->blend(0.5), 0.25);
  EXPECT_EQ(told(item(*p, "endless").code->blend(0.5)), "range");
  FakeQuestions q;
  q.time = 2;
  std::uint64_t cost = 0;
  const auto& faster = *item(*p, "faster").code;
  EXPECT_EQ(std::get<double>(*faster.value(q, {}, cost)), 9);
  EXPECT_EQ(std::get<double>(*faster.value(q, {Value(2.0)}, cost)), 18);
  EXPECT_EQ(cost, 220u);
  EXPECT_EQ(item(*p, "lost").code->value(q, {}, cost).error().message, "value('nowhere'): there is no 'nowhere'");
  q.procedures["ball"] = item(*p, "faster").code;  // reads itself
  EXPECT_EQ(told(faster.value(q, {}, cost)), "type");
  EXPECT_TRUE(mentions(faster.value(q, {}, cost), "300"));
  FakeHost host;
  const auto& twice = *item(*p, "twice").code;
  EXPECT_TRUE(twice.command(host, {"hop"}));
  EXPECT_EQ(host.lines, (std::vector<std::string>{"hop", "hop"}));
  EXPECT_EQ(twice.command(host, {"bad"}).error().message, "there is no command 'bad'");
  EXPECT_EQ(twice.command(host, {}).error().message, "twice what?");
  ASSERT_EQ(p->functions.size(), 1u);
  EXPECT_EQ(p->functions[0].name + p->functions[0].type, "windvector");
  EXPECT_EQ(p->functions[0].numbers, (std::vector<double>{1, 2, 3}));
}

// shows: G19
TEST(Plugins, BadOnesAreRefusedInWords) {
  EXPECT_EQ(error("nowhere.so"), "nowhere.so: no such file");
  EXPECT_EQ(error(PLUGIN_DIR), PLUGIN_DIR ": not a plug-in: it is not a regular file");
  const std::string text = testing::TempDir() + "betwixt_text.so";
  std::ofstream(text) << "not a library";
  EXPECT_EQ(
      error(text),
      text + ": not a plug-in: it is not a shared library for this machine, or a library that it needs is missing");
  EXPECT_EQ(error(at("missing")), at("missing") + ": not a plug-in: it has no BETWIXT_PLUGIN");
  EXPECT_EQ(
      error(at("newer")),
      at("newer") + ": it is made for version 3 of the plug-in interface; this program supports versions up to 2");
  EXPECT_EQ(error(at("crashing")), at("crashing") + ": it crashes when loaded");
  EXPECT_EQ(error(at("double")), at("double") + ": it registers 'same' twice");
  EXPECT_EQ(error(at("refusing")), at("refusing") + ": it refuses to be loaded (its code is 7)");
}

}  // namespace
}  // namespace betwixt
