// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The picture, in which you select and move objects. Edits become script lines. The free camera and the overlays belong
// to the view alone, and change no film.
#pragma once

#include <QWidget>
#include <optional>
#include <string>

#include "playback/film_player.h"
#include "studio/shell/workspace.h"
#include "studio/viewport/ghosts.h"
#include "studio/viewport/handles.h"
#include "studio/viewport/kept_pictures.h"
#include "studio/viewport/motion_handles.h"
#include "studio/viewport/picture_maker.h"
#include "studio/viewport/trails.h"

class QMenu;
class QToolButton;
class QComboBox;

namespace betwixt::studio {

// Overlays and tools.
struct ViewportSwitches {
  Tool tool = Tool::move;
  bool own_axes = false;  // handles along the object's axes instead of the world's
  bool auto_key = false;  // each edit becomes an event
  bool trails = true, ghosts = false, grid = false, handles = true;
  bool safe = false, thirds = false;  // guides in the frame of the film's camera
  bool key_ghosts = false;            // the selection at the events around the playhead
  bool snaps = false;                 // what a hand moves goes to points and surfaces of other objects
  bool measures = false;              // clicks measure distances
  bool guides = false;                // rulers at the edges, and the guides that the user has dragged out of them
  Guides own_guides = {};
  friend bool operator==(const ViewportSwitches&, const ViewportSwitches&) = default;
};

class Viewport : public QWidget {
  Q_OBJECT
 public:
  explicit Viewport(Workspace&, QWidget* parent = nullptr);
  ~Viewport() override;

  // Waits for the picture of the current time and film. For screenshots and tests.
  void await_picture();
  // Makes all pictures of the part that plays, keeps them, and then plays it. Ends if somebody moves the playhead.
  void fill_memory();
  bool fills_memory() const { return fills_; }
  // Switches all overlays and tools off.
  void set_plain(bool);
  void set_style(const std::string& style);
  const std::string& style() const { return style_; }
  QSize sizeHint() const override { return {640, 360}; }

  const ViewportSwitches& switches() const { return switches_; }
  void set_switches(const ViewportSwitches&);
  void flip(bool ViewportSwitches::*which);
  // The free camera; without it the view is the film camera's. It starts at the film camera.
  bool is_free() const { return free_ || through_; }
  void set_free(bool);
  // Looks through the active object, a light for example, and goes with it. Once more looks as before.
  void look_through();
  ObjectId looks_through() const { return through_; }
  void isolate();  // shows only the selection and the lights; once more shows everything
  // Makes this one of several views, which looks along a direction without perspective at the whole film.
  void stay_at_side(Vec3 direction);
  void look_along(Vec3 direction);  // "front" is (0 0 -1)
  void look_from_behind();          // turns the view by half a turn
  void frame_selected();            // all objects if none is selected
  void toggle_perspective();
  // Moves the film's camera to the free camera. Creates one if the film has none.
  void bring_camera();
  void bring_selected();         // moves the active object to the free camera
  ObjectId film_camera() const;  // the one in use now; empty if the film has none
  void select_all();
  // Starts a transform of the selection by the mouse, without a handle: G, R and S.
  void take(Tool);
  bool pulls() const { return pull_.has_value(); }
  // Puts guides through the active object, or removes them if they are there.
  void guide_selection();
  void ask_guide();                                    // at a place that the user types
  const QString& refusal() const { return refusal_; }  // why some object cannot be transformed; or ""

  // Describes the measured distance: "3.6 m (2 3 0)"; "" before two points.
  QString measure_words() const;
  // Return where objects are in the widget, and the object at a point. Public for tests too.
  QRect frame_box() const;    // the film's picture in the widget
  QRect picture_box() const;  // the rendered picture
  Scope scope() const;
  std::optional<Hit> hit(QPointF) const;
  const Frame& frame() const;
  // Returns the line that imports a file at a point of the widget.
  // "" if the user stops the work.
  std::string line_for_file(const QString& file, QPointF) const;
  // Imports it, or opens it if it is a script.
  bool import_file(const QString& file, QPointF);

 Q_SIGNALS:
  void style_changed();
  void picture_came(const betwixt::studio::PictureMade&);
  void switches_changed();

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void showEvent(QShowEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void leaveEvent(QEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void dragEnterEvent(QDragEnterEvent*) override;
  void dragMoveEvent(QDragMoveEvent*) override;
  void dragLeaveEvent(QDragLeaveEvent*) override;
  void dropEvent(QDropEvent*) override;

 private:
  enum class Gesture { none, orbit, pan, zoom, press, box, pull, motion, guide };
  struct Icon {  // of an object without a shape
    ObjectId id;
    Kind kind;
    Vec3 place;
  };

  // Pictures (viewport_pictures.cpp)
  PictureWanted wanted();
  void ask();
  void take_picture(const PictureMade&);
  void keep(const PictureMade&);
  void show_kept();
  void fill_next();
  void forget();  // drops all caches of the film and the time
  Time shown_time() const;
  Camera eye() const;

  // Navigation (viewport_navigation.cpp)
  std::optional<Camera> own_eye(Time) const;  // nullopt: the film's camera
  void move_eye(const Camera&);
  Vec3 pivot() const;
  Box box_of(const std::vector<ObjectId>&) const;
  std::vector<ObjectId> with_what_hangs_on(const std::vector<ObjectId>&) const;
  void drag_eye(QPointF by);
  QString side_words() const;  // "top" if the free view looks down without perspective
  bool looking_key(int key, Qt::KeyboardModifiers);

  // Edits (viewport_hands.cpp)
  const Hand& grip() const;
  std::optional<Handles> handles() const;
  // Transforms the selected objects, or one event of the selection.
  void begin_pull(Tool, Part, QPointF from, std::optional<EventAt> = {});
  void say_refusal();
  void go_on_pulling(QPointF, Qt::KeyboardModifiers);
  void show_pull();
  void end_pull(bool carry_out);
  bool pulling_key(QKeyEvent*);
  // Of the motion of the object that is selected alone.
  std::optional<MotionHandles> motion_handles() const;
  void drag_motion(QPointF, Qt::KeyboardModifiers);
  void end_motion(bool carry_out);
  void add_motion_menu(QMenu&);
  void press_on(QPointF, Qt::KeyboardModifiers);

  // Snapping and measuring (viewport_snapping.cpp)
  std::optional<Vec3> snap_place(QPointF, const Marks& without) const;
  void measure_to(QPointF);
  std::vector<Vec3> measured(QPointF) const;
  void paint_measure(QPainter&, const Scope&) const;
  std::optional<Vec3> surface_under(QPointF) const;
  Vec3 place_under(QPointF) const;
  std::optional<Box> box_after(const std::string& line, const std::string& name) const;
  void tell_size(ObjectId, double depth) const;
  std::vector<std::string> lines_for_drop(const QDropEvent&) const;
  void tell_refusal();
  void select_in_box(Qt::KeyboardModifiers);
  const std::vector<Icon>& icons() const;

  QString in_words(ObjectId) const;

  // The user's guides (viewport_guides.cpp)
  std::optional<std::pair<int, int>> guided_axes() const;  // nullopt: this view shows no guides
  double ruler() const;                                    // its width; 0 if there is none
  double place_on(int axis, QPointF) const;                // metres
  double spot_on(int axis, double place) const;            // pixels
  std::optional<Guide> guide_at(QPointF) const;
  bool take_guide(QPointF);
  void drag_guide(QPointF, Qt::KeyboardModifiers);
  void end_guide(bool carry_out);
  void show_cursor_of_guide(QPointF);
  void set_guides(Guides);
  Guides shown_guides() const;
  void paint_own_guides(QPainter&) const;
  void paint_ruler(QPainter&, bool across) const;

  // Painting (viewport_painting.cpp)
  QImage layer() const;  // clear, of the widget's size
  bool is_bright() const;
  void paint_grid(QPainter&, const Scope&);
  void draw_grid(QPainter&, const Scope&) const;
  std::pair<Vec3, double> grid_middle(const Scope&) const;  // on its plane, and its depth
  double grid_step(const Scope&) const;                     // metres between two lines
  void clear_things(QPainter&, const Scope&) const;
  void paint_outlines(QPainter&, const Scope&);
  void paint_brackets(QPainter&, const Scope&, ObjectId);
  void paint_icons(QPainter&, const Scope&);
  void paint_pull(QPainter&);
  void paint_words(QPainter&);
  void paint_auto_key(QPainter&);
  void paint_camera(QPainter&, const Scope&);
  void paint_guides(QPainter&) const;

  void make_corner();  // viewport_corner.cpp
  void show_corner();
  void place_corner();

  Workspace& workspace_;
  PictureMaker maker_;
  PictureMade shown_;
  KeptPictures kept_;
  std::uint64_t asked_ = 0, kept_since_ = 0;  // numbers of requests: the latest; the first of kept_
  bool fills_ = false, fills_by_itself_ = false;
  std::string style_ = "shaded";
  ViewportSwitches switches_;
  std::optional<Camera> free_;
  std::optional<Vec3> side_;  // along which one of several views looks
  ObjectId through_;          // the object that the view looks through
  double last_depth_ = 10;    // of the last point the user looked at

  // Caches for the film at the time, filled when needed.
  mutable FilmPlayer film_;
  mutable std::optional<Frame> frame_;
  mutable std::optional<Hand> grip_;
  mutable std::optional<std::vector<Icon>> icons_;
  Trails trails_;
  Ghosts ghosts_;
  HeldShapes outlined_shapes_;
  struct Layer {  // repainted if one of these changes
    QImage image;
    std::vector<ObjectId> of;
    Camera eye;
    QRect box;
  };
  std::optional<Layer> outline_, grid_;
  std::vector<ObjectId> bracketed_;  // marked by their corners, because their outlines would take too long

  Gesture gesture_ = Gesture::none;
  QPointF from_, at_;
  Vec3 pivot_;
  std::optional<ObjectId> pressed_, clicked_;  // what a drag moves; what a click selects
  std::optional<Pull> pull_;
  struct MotionDrag {
    MotionHandles handles;
    MotionHandles::Part part;
    double turned = 0;  // radians: the angle until now, whole turns included
    std::string line = {};
  };
  std::optional<MotionDrag> motion_drag_;
  std::optional<MotionHandles::Part> hot_motion_;
  struct GuideDrag {
    Guides others;  // the guides without the one that is dragged
    std::optional<Guide> first;
    int axis;
    std::optional<Guide> now;  // nullopt: it is over a ruler or outside, and goes away
  };
  std::optional<GuideDrag> guide_drag_;
  Box held_box_;                                    // around what is pulled, at the start
  Marks held_;                                      // what is pulled, with all that hangs on it
  std::vector<Vec3> measured_;                      // at most two points
  bool pull_by_keys_ = false, called_off_ = false;  // the latter by the button that otherwise opens a menu
  Part hot_ = Part::none;
  QString refusal_;
  bool plain_ = false;

  QWidget *corner_ = nullptr, *eye_corner_ = nullptr;
  QToolButton *eye_button_ = nullptr, *tools_[3] = {}, *toggles_[7] = {};
  QComboBox* styles_ = nullptr;
};

}  // namespace betwixt::studio
