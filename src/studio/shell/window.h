// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The main window: the picture in the middle, and panels around it that you can move, close and stack.
#pragma once

#include <QCloseEvent>
#include <QMainWindow>
#include <vector>

#include "studio/shell/workspace.h"

class QDockWidget;
class QLabel;
class QMenu;

namespace betwixt::studio {

struct ActionRow;
class Films;
class Sound;
class Viewport;
class Views;

class Window : public QMainWindow {
  Q_OBJECT
 public:
  struct Manner {
    bool bare = false;       // only the picture and the ruler, to play films
    bool remembers = false;  // keeps the panel layout, the theme and recent files between runs
    Films* films = nullptr;  // the window around this one, with a tab for each film; null: there is only this film
  };
  Window(Workspace&, Manner);
  explicit Window(Workspace& workspace) : Window(workspace, Manner()) {}
  ~Window() override;

  Workspace& workspace() { return workspace_; }
  const Workspace& workspace() const { return workspace_; }
  // The view of the picture in which the user worked last.
  Viewport& viewport();
  const Viewport& viewport() const;
  Views& views() { return *views_; }
  const Views& views() const { return *views_; }
  QWidget* panel(const QString& name) const;  // by its object name; null if there is none

  // Applies one of layouts(). Returns false if the name is unknown.
  bool set_layout(const QString& name);
  static QStringList layouts();
  static QStringList films_opened_last();
  // Settings of the user, which all windows share.
  void set_text_size(double);  // of all text and what is measured by it; 1 is the size at the first start
  double text_size() const { return text_size_; }
  void set_light(bool);
  bool is_light() const;
  void insert_time();
  void remove_time();
  void add_note();
  void ask_breakdown();
  void ask_retiming();

  // The film of this window and others. Without tabs, another film replaces this one.
  QString film_name() const;
  bool is_saved() const;      // a film that was only begun needs no saving
  bool is_untouched() const;  // a film without a file that the user has not changed: another one may take its place
  bool may_leave();           // asks about unsaved changes
  void leave();               // ends the session, without a question
  bool has_left() const { return leaving_; }
  void open_film(const QString& file);
  Window* place_for_another();  // this window or that of a new tab; null if the user keeps the film here
  void go_to_film(int by);      // the next tab or the one before
  void close_film();

  // Actions.
  void open_asking();
  void new_film();  // lets the user choose a film to begin with, or one that there is already; Escape leaves this one
  bool save();      // asks for a name if there is none
  bool save_as();
  void make_film();
  void save_session();  // the lines of this session
  Sound& sound() { return *sound_; }
  const Sound& sound() const { return *sound_; }
  void find_command();  // the palette
  void add_object();    // the menu of kinds, at the pointer
  void show_panel(const QString& name);
  void show_keys();
  void show_manual();
  void show_about();
  void show_preferences(const QString& page = {});
  void remember();        // keeps the layout of the panels and the place of the window
  void show_film_anew();  // for a new window on a workspace that has a film already
  // Opens the film for new users.
  void open_example();
  const std::string& first_text() const { return first_text_; }
  void begun_with(const std::string& text) { first_text_ = text; }  // by an earlier window on the same film
  void begin_film(const std::string& text);  // a new film that has this text; it needs no saving until it is changed

 Q_SIGNALS:
  void film_named();  // it has another name, or was changed or saved

 protected:
  void hideEvent(QHideEvent*) override;
  void showEvent(QShowEvent*) override;
  void closeEvent(QCloseEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;

 private:
  void show_work();
  void add_panels();
  void add_menus();
  void name_film();
  void note_file();
  void list_recent();
  void recall();
  void follow_guides();
  void apply(const QString& preference);
  void apply_keys();
  void scale_text(double);
  std::optional<std::string> answer(const Session::Question&);

  Workspace& workspace_;
  const Manner manner_;
  double text_size_;  // before all widgets, which measure themselves by it
  Views* views_;
  Viewport* viewport_;  // the first of them
  Sound* sound_;
  std::vector<QDockWidget*> docks_;
  std::vector<QDockWidget*> floating_;  // panels beside the window that are hidden together with it
  QMenu *recent_ = nullptr, *kinds_ = nullptr;
  QLabel* said_;
  std::string first_text_;  // of a film without a file
  QByteArray arranged_;     // the initial panel layout
  double script_size_ = 1;
  bool leaving_ = false;
  std::vector<std::pair<QAction*, const ActionRow*>> actions_;
};

}  // namespace betwixt::studio
