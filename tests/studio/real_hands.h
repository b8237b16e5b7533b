// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Mouse and keyboard input for a whole window. Without a display the toolkit makes the events. On a display, xdotool
// moves the real mouse and presses real keys, so that the window gets the events of the display, as from a person.
#pragma once

#include <QAbstractNativeEventFilter>
#include <QProcess>
#include <QtTest/QtTest>
#include <QtWidgets>
#include <array>
#include <memory>

namespace betwixt::studio {

class Hands {
 public:
  explicit Hands(QWidget& window) : window_(window) {}
  virtual ~Hands() = default;
  Hands(const Hands&) = delete;
  Hands& operator=(const Hands&) = delete;

  virtual void move(QWidget&, QPoint) = 0;
  virtual void press(QWidget&, QPoint, Qt::KeyboardModifiers = {}, Qt::MouseButton = Qt::LeftButton) = 0;
  virtual void release(QWidget&, QPoint, Qt::KeyboardModifiers = {}, Qt::MouseButton = Qt::LeftButton) = 0;
  virtual void double_click(QWidget&, QPoint) = 0;
  // Presses a key such as "Ctrl+Z" or "Return" for the widget with the keyboard focus.
  virtual void key(const QString&) = 0;
  virtual void type(const QString&) = 0;

  void click(QWidget& on, QPoint at, Qt::KeyboardModifiers held = {}, Qt::MouseButton button = Qt::LeftButton) {
    move(on, at), press(on, at, held, button), release(on, at, held, button);
  }
  void click(QWidget& on) { click(on, on.rect().center()); }
  void drag(QWidget& on, QPoint from, QPoint to) {
    move(on, from), press(on, from);
    for (int i = 1; i <= 4; ++i) move(on, from + (to - from) * i / 4);
    release(on, to);
  }

 protected:
  // Gives the keyboard focus to an open dialog if there is one, otherwise to the window, as a window manager would do.
  // Returns that window.
  QWindow* with_the_keys() const {
    const QWidget* asks = QApplication::activeModalWidget();
    QWindow* w = (asks ? asks : &window_)->windowHandle();
    if (QGuiApplication::focusWindow() != w) w->requestActivate();
    if (!QTest::qWaitFor([&] { return QGuiApplication::focusWindow() == w; })) qFatal("no window gets the keys");
    return w;
  }

 private:
  QWidget& window_;
};

class ToolkitHands : public Hands {
 public:
  using Hands::Hands;
  void move(QWidget& w, QPoint at) override { QTest::mouseMove(window(w), in_window(w, at)); }
  void press(QWidget& w, QPoint at, Qt::KeyboardModifiers held, Qt::MouseButton button) override {
    QTest::mousePress(window(w), button, held, in_window(w, at));
  }
  void release(QWidget& w, QPoint at, Qt::KeyboardModifiers held, Qt::MouseButton button) override {
    QTest::mouseRelease(window(w), button, held, in_window(w, at));
  }
  void double_click(QWidget& w, QPoint at) override {
    QTest::mouseDClick(window(w), Qt::LeftButton, {}, in_window(w, at));
  }
  void key(const QString& k) override { QTest::keySequence(with_the_keys(), QKeySequence(k)); }
  void type(const QString& text) override {
    for (const QChar c : text) QTest::keyClick(with_the_keys(), c.toLatin1());
  }

 private:
  static QWindow* window(QWidget& w) { return w.window()->windowHandle(); }
  static QPoint in_window(QWidget& w, QPoint at) { return w.mapTo(w.window(), at); }
};

class DisplayHands : public Hands, QAbstractNativeEventFilter {
 public:
  explicit DisplayHands(QWidget& window) : Hands(window) {
    qApp->installNativeEventFilter(this);
    QApplication::setDoubleClickInterval(0);  // two clicks must not become a double click on a fast machine
  }
  void move(QWidget& w, QPoint at) override {
    const QPoint to = w.mapToGlobal(at);
    if (QCursor::pos() == to) return;
    xdotool({"mousemove", QString::number(to.x()), QString::number(to.y())}, moved, 1);
  }
  void press(QWidget& w, QPoint at, Qt::KeyboardModifiers held, Qt::MouseButton button) override {
    move(w, at);
    xdotool(holding("keydown", held) + QStringList{"mousedown", number(button)}, pressed, 1);
  }
  void release(QWidget& w, QPoint at, Qt::KeyboardModifiers held, Qt::MouseButton button) override {
    move(w, at);
    xdotool(QStringList{"mouseup", number(button)} + holding("keyup", held), released, 1);
  }
  void double_click(QWidget& w, QPoint at) override {
    QApplication::setDoubleClickInterval(60'000);  // a double click must stay one on a slow machine
    click(w, at), click(w, at);
    QApplication::setDoubleClickInterval(0);
  }
  void key(const QString& k) override {
    with_the_keys();
    QStringList parts = k.split('+');
    QString& last = parts.back();
    if (last.size() == 1) last = last.toLower();
    if (last == "Space") last = "space";  // the display's name of the key
    for (QString& held : parts)
      if (&held != &last) held = held.toLower();
    xdotool({"key", parts.join('+')}, key_released, 1);
  }
  void type(const QString& text) override {
    with_the_keys();
    xdotool({"type", "--delay", "1", text}, key_released, static_cast<int>(text.size()));
  }

 private:
  // Numbers of the display's events.
  enum Event { key_released = 3, pressed = 4, released = 5, moved = 6, extended = 35 };

  static QString number(Qt::MouseButton b) { return b == Qt::RightButton ? "3" : "1"; }
  static QStringList holding(const QString& verb, Qt::KeyboardModifiers held) {
    QStringList all;
    if (held & Qt::ControlModifier) all += {verb, "ctrl"};
    if (held & Qt::ShiftModifier) all += {verb, "shift"};
    return all;
  }
  // Calls xdotool and waits until the window has got `times` events of this kind.
  void xdotool(const QStringList& what, Event event, int times) {
    const int before = come_[event];
    QProcess process;
    process.start("xdotool", what);
    if (!process.waitForFinished() || process.exitCode() != 0) qFatal("xdotool %s", qPrintable(what.join(' ')));
    if (!QTest::qWaitFor([&] { return come_[event] >= before + times; }))
      qFatal("xdotool %s: it never came", qPrintable(what.join(' ')));
    QApplication::processEvents();
  }
  bool nativeEventFilter(const QByteArray&, void* message, qintptr*) override {
    constexpr unsigned char modifiers[] = {37, 50, 62, 64, 105};  // control, shift, alt
    const auto* bytes = static_cast<const unsigned char*>(message);
    const unsigned event = (bytes[0] & 0x7f) == extended ? bytes[8] : bytes[0] & 0x7f;
    if (event < come_.size() &&
        (event != key_released || std::ranges::find(modifiers, bytes[1]) == std::end(modifiers)))
      ++come_[event];
    return false;
  }
  std::array<int, 7> come_{};
};

// Shows a window and returns the hands that work in it; null if it does not become active.
inline std::unique_ptr<Hands> hands_on(QWidget& window) {
  window.setGeometry(0, 0, 1380, 880);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return nullptr;
  window.activateWindow();
  if (!QTest::qWaitForWindowActive(&window)) return nullptr;
  if (QGuiApplication::platformName() == "xcb") return std::make_unique<DisplayHands>(window);
  return std::make_unique<ToolkitHands>(window);
}

}  // namespace betwixt::studio
