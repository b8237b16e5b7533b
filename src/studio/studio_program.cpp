// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt-studio: what `betwixt studio` and `betwixt play` start where there is a display.
#include <QApplication>
#include <QCommandLineParser>
#include <QSurfaceFormat>
#include <cstdio>

#include "betwixt/language.h"
#include "studio/theme.h"
#include "studio/viewport.h"
#include "studio/window.h"

int main(int argc, char** argv) {
  using namespace betwixt;
  using namespace betwixt::studio;
  // A screenshot needs no display.
  for (int i = 1; i < argc; ++i)
    if (std::string_view(argv[i]).starts_with("--screenshot")) qputenv("QT_QPA_PLATFORM", "offscreen");
  QApplication app(argc, argv);
  QApplication::setApplicationName("betwixt-studio");
  QCommandLineParser line;
  line.addPositionalArgument("FILE", "the script");
  line.addOptions({{"screenshot", "a picture of the window, then the end", "OUT.png"},
                   {"at", "the time that it shows", "TIME"},
                   {"layout", "how the panels lie", "NAME"},
                   {"size", "of the window", "WxH"},
                   {"light", "light colours"},
                   {"bare", "the picture alone, to play"}});
  line.addHelpOption();
  line.process(app);
  set_theme(app, line.isSet("light") ? Theme::light : Theme::dark);
  Desk desk;
  Window window(desk, line.isSet("bare"));
  if (!desk.open(line.positionalArguments().value(0))) {
    std::fputs(desk.last_said().c_str(), stderr);
    return 1;
  }
  if (line.isSet("size")) {
    const QStringList wh = line.value("size").split('x');
    window.resize(wh.value(0).toInt(), wh.value(1).toInt());
  }
  if (line.isSet("layout") && !window.set_layout(line.value("layout"))) {
    std::fprintf(stderr, "there is no layout '%s': %s\n", qPrintable(line.value("layout")),
                 qPrintable(Window::layouts().join(", ")));
    return 2;
  }
  if (line.isSet("at")) {
    const Result<Time> at = parse_time(line.value("at").toStdString(), desk.document());
    if (!at) {
      std::fprintf(stderr, "%s\n", at.error().message.c_str());
      return 2;
    }
    desk.go_to(*at);
  }
  window.show();
  if (line.isSet("screenshot")) {
    QApplication::processEvents();
    window.viewport().await_picture();
    QApplication::processEvents();
    return window.grab().save(line.value("screenshot")) ? 0 : 3;
  }
  if (line.isSet("bare")) desk.play(1);
  return QApplication::exec();
}
