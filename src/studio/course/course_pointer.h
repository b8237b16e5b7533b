// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A frame around the place in the window where the next step of an exercise is done. Places are
//   widget NAME        a control, by its object name
//   property NAME      the value of a function in the properties
//   diamond NAME       its diamond there
//   object NAME        an object in the picture
//   row NAME           its row in the outliner
//   frame TIME         a place on the ruler
//   event TARGET TIME  an event in the sheet
//   menu NAME          a menu of the window
// After a place, `> WORDS` names a row of the menu that opens there, and `> WORDS` again a row below that. These rows
// are bold while the menu is open.
#pragma once

#include <QStringList>
#include <QWidget>
#include <string>

namespace betwixt::studio {

class Window;

class CoursePointer : public QWidget {
 public:
  explicit CoursePointer(Window&);
  // Shows the frame there, or hides it if there is no such place now. A new place is brought to the front. Call it
  // again when the window may have changed.
  void point_at(const std::string& place);

 protected:
  void paintEvent(QPaintEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  struct Spot {
    QWidget* on = nullptr;
    QRect box;
  };
  Spot find(const std::string& place) const;
  void bring_forward(QWidget*);

  Window& window_;
  std::string place_;
  bool brought_ = false;  // to the front
  QStringList rows_;      // of menus
};

}  // namespace betwixt::studio
