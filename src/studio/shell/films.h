// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Several films in one window: a tab for each, with a window and a workspace of its own. The tabs are hidden while
// there is only one film.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "studio/shell/window.h"

class QStackedWidget;
class QTabBar;

namespace betwixt::studio {

class Films : public QWidget {
  Q_OBJECT
 public:
  explicit Films(const LoadOptions& = {}, Window::Manner = {});
  ~Films() override;

  Window& current() const;
  std::vector<Window*> windows() const;  // in the order of the tabs
  QTabBar& tabs() { return *tabs_; }

  void go_to(Window&);
  void go_on(int by);  // by tabs, round the ends
  // The tab of the current film if that is untouched, otherwise a new one, which comes to the front.
  Window& place_for_another();
  // Goes to the tab of the film if it is open already.
  void open(const QString& file);
  void close_film(Window&);  // asks about unsaved changes; without its last film the window closes
  void speak_anew();         // after a change of the language
  // After a crash: shows the films without a file that were open beside the first one.
  void recover_others(Session::Earlier);

 protected:
  void closeEvent(QCloseEvent*) override;

 private:
  struct Page {
    std::unique_ptr<Workspace> workspace;
    Window* window;
  };
  Window* make_window(Workspace&);
  Window& add(const std::string& nameless_journal = {});
  void remove(Window&);
  int index_of(const Window&) const;
  void show_page();
  void name_tabs();
  std::string free_journal() const;

  const LoadOptions options_;
  Window::Manner manner_;
  QTabBar* tabs_;
  QStackedWidget* stack_;
  std::vector<Page> pages_;  // in the order of the tabs
};

}  // namespace betwixt::studio
