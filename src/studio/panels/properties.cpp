// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/properties.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QPainter>
#include <QStyle>
#include <QVBoxLayout>

#include "betwixt/language.h"
#include "editor/help.h"
#include "editor/made_by.h"
#include "editor/plain_values.h"
#include "scene/document.h"
#include "studio/panels/diagram_lines.h"
#include "studio/shell/control_names.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"
#include "studio/viewport/hand.h"
#include "studio/viewport/kind_icons.h"

namespace betwixt::studio {
namespace {

// Groups of functions in the order shown: the place, the kind's own functions, the look, functions of the film.
enum class Group : std::uint8_t { place, own_kind, look, gradient, finish, film };
Group group_of(const FunctionView& f) {
  const auto built_in = built_in_functions();
  if (f.id >= built_in.size()) return Group::film;
  const FunctionSpec& spec = built_in[f.id];
  if (spec.name == "display") return Group::look;
  if (is_of_finish(static_cast<FunctionId>(f.id))) return Group::finish;
  if (is_of_gradient(static_cast<FunctionId>(f.id))) return Group::gradient;
  if (!(spec.kinds & bit(Kind::group))) return Group::own_kind;
  return spec.place ? Group::place : Group::look;
}

// A label that elides a text that is too long.
class ShortLabel : public QLabel {
 public:
  using QLabel::QLabel;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    style()->drawItemText(&p, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(),
                          fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width()), foregroundRole());
  }
};

// Returns the icon of a track: a filled diamond if it has an event now, an outline if it has others, a dot if it has
// none.
QIcon diamond(bool here, bool any) {
  QPixmap pix(32, 32);
  pix.fill(Qt::transparent);
  QPainter p(&pix);
  p.setRenderHint(QPainter::Antialiasing);
  const double r = any ? 11 : 5;
  p.setPen(QPen(any ? colors().event : colors().dim, 3));
  if (here) p.setBrush(colors().event);
  p.drawPolygon(QPolygonF({{16, 16 - r}, {16 + r, 16}, {16, 16 + r}, {16 - r, 16}}));
  return pix;
}

// Reads "couple to car", as the attachment editor writes it. Returns nullopt if the parent does not exist.
std::optional<Attachment> attachment_of(const QString& text, const Document& d) {
  const QStringList words = text.split(' ');
  static const QStringList kinds{"detach", "letgo", "hang", "attach", "couple"};
  const auto kind = static_cast<AttachmentKind>(std::max<qsizetype>(0, kinds.indexOf(words[0])));
  const ObjectId parent = d.find(words.value(2).toStdString());
  if (kind >= AttachmentKind::hang && !parent) return std::nullopt;
  return Attachment{kind, kind >= AttachmentKind::hang ? parent : ObjectId{}, kind >= AttachmentKind::hang};
}

// Returns the line of an event that keeps the object's attachment at a time.
std::string what_holds(const Document& d, ObjectId id, Time t) {
  Attachment held;
  for (const AttachmentSpan& span : attachments(d, id))
    if (span.from <= t && t < span.until && !span.computed) held = span.to;
  held.keep_world = held.kind >= AttachmentKind::hang;
  const std::string line = line_that_holds(d, id, t, held);
  return line.starts_with("at ") ? line : "at " + format_time(t, d) + " " + line;
}

}  // namespace

Properties::Properties(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      icon_(new QLabel(this)),
      kind_(new ShortLabel(this)),
      film_(new FilmSettings(workspace)),
      film_area_(new QScrollArea(this)),
      name_(new QLineEdit(this)),
      area_(new QScrollArea(this)) {
  setObjectName("properties");
  setWindowTitle(tr("Properties"));
  name_->setObjectName("name");
  name_->setFrame(false);
  name_->setToolTip(tr("Renames the object: `rename OLD NEW`"));
  QFont bold = name_->font();
  bold.setBold(true);
  name_->setFont(bold);
  film_area_->setWidget(film_);
  for (QScrollArea* area : {area_, film_area_}) {
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
  }
  auto* head = new QHBoxLayout;
  head->setContentsMargins(6, 4, 6, 2);
  head->addWidget(icon_);
  head->addWidget(name_, 3);
  head->addWidget(kind_, 2);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addLayout(head);
  all->addWidget(film_area_, 1);
  all->addWidget(area_, 1);
  connect(name_, &QLineEdit::editingFinished, this, &Properties::rename);
  connect(&workspace, &Workspace::document_changed, this, &Properties::refresh);
  connect(&workspace, &Workspace::selection_changed, this, &Properties::refresh);
  connect(&workspace, &Workspace::time_changed, this, &Properties::refresh);
  connect(&workspace, &Workspace::colors_changed, this, [this] { built_.clear(), refresh(); });
}

QSize Properties::sizeHint() const { return {38 * fontMetrics().horizontalAdvance('m'), 400}; }

void Properties::showEvent(QShowEvent* e) {
  QWidget::showEvent(e);
  refresh();
}

void Properties::resizeEvent(QResizeEvent* e) {
  QWidget::resizeEvent(e);
  show_sources();
}

// Where values come from is shown only if there is room: the values are more important.
void Properties::show_sources() {
  const int narrow = 27 * fontMetrics().height();
  for (const auto& row : rows_) row->made->setVisible(width() >= narrow);
}

ObjectId Properties::leading() const {
  return workspace_.selected().empty() ? ObjectId{} : workspace_.selected().back();
}

void Properties::rename() {
  const std::string was = workspace_.name(leading()), now = name_->text().trimmed().toStdString();
  if (!name_->isModified() || was.empty() || now.empty() || now == was) return;
  name_->setModified(false);
  workspace_.say("rename " + was + " " + now);
  refresh();
}

// Updates the values. Builds the rows again only if the object needs other ones.
void Properties::refresh() {
  if (!isVisible() || refreshing_) return;
  refreshing_ = true;
  const Document& d = workspace_.document();
  const ObjectId id = leading();
  film_area_->setVisible(!id);
  if (!id) film_->refresh();
  area_->setVisible(static_cast<bool>(id)), name_->setVisible(static_cast<bool>(id));
  kind_->setVisible(static_cast<bool>(id)), icon_->setVisible(static_cast<bool>(id));
  if (id) {
    const QString name = text_of(d.name(id));
    if (!(name_->hasFocus() && name_->isModified()) && name_->text() != name) show_text(*name_, name);
    const std::size_t others = workspace_.selected().size() - 1;
    kind_->setText(text_of(name_of(kind(d, id))) + (others > 0 ? tr(" and %1 more").arg(others) : QString()));
    std::vector<FunctionView> all = functions(d, id);
    std::vector<Target> targets;
    for (const FunctionView& f : all) targets.emplace_back(id, f.id);
    const std::vector<Value> now = workspace_.program().read(targets, workspace_.time());
    std::vector<std::pair<std::string, EditorKind>> wanted;
    for (std::size_t i = 0; i < all.size(); ++i)
      wanted.emplace_back(all[i].name,
                          editor_of(all[i], kind(d, id), now[i],
                                    all[i].animated && !made_by(d, targets[i], workspace_.time()).code.empty()));
    if (wanted != built_ || kind(d, id) != built_of_) {
      built_ = wanted, built_of_ = kind(d, id);
      icon_->setPixmap(kind_icon(*built_of_).pixmap(fontMetrics().height(), fontMetrics().height()));
      rebuild();
    }
    for (const auto& row : rows_)
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name == row->name) row->of = all[i], show_row(*row, now[i]);
  }
  refreshing_ = false;
}

void Properties::rebuild() {
  rows_.clear();
  auto* inside = new QWidget;
  auto* column = new QVBoxLayout(inside);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  const Document& d = workspace_.document();
  const std::vector<FunctionView> all = functions(d, leading());
  const std::pair<Group, QString> groups[] = {
      {Group::place, tr("Place")},   {Group::own_kind, text_of(name_of(*built_of_))},
      {Group::look, tr("Look")},     {Group::gradient, tr("Gradient")},
      {Group::finish, tr("Finish")}, {Group::film, tr("Film")}};
  for (const auto& [group, title] : groups) {
    QWidget* section = nullptr;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (group_of(all[i]) != group) continue;
      if (!section) {
        section = make_section(title);
        auto* fold = new QToolButton(inside);
        fold->setText(title);
        fold->setObjectName("fold_" + title);
        fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        fold->setAutoRaise(true);
        fold->setCheckable(true);
        fold->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        const auto show = [this, fold, section, title](bool open) {
          fold->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
          section->setVisible(open);
          folded_.removeAll(title);
          if (!open) folded_.push_back(title);
        };
        fold->setChecked(!folded_.contains(title));
        column->addWidget(fold);
        column->addWidget(section);
        show(fold->isChecked());
        connect(fold, &QToolButton::toggled, this, show);
      }
      add_row(section, all[i], built_[i].second);
    }
  }
  column->addStretch(1);
  // An editor of the old rows may have caused this, so it lives on until it has finished. It says nothing more, not
  // even if it loses the focus because it is hidden.
  if (QWidget* old = area_->widget()) {
    for (QWidget* w : old->findChildren<QWidget*>()) w->disconnect(this);
    for (PartsView* parts : old->findChildren<PartsView*>()) parts->retire();
    area_->takeWidget();
    old->hide(), old->deleteLater();
  }
  area_->setWidget(inside);
  show_sources();
}

QWidget* Properties::make_section(const QString& title) {
  auto* section = new QWidget;
  section->setObjectName("section_" + title);
  auto* grid = new QGridLayout(section);
  grid->setContentsMargins(6, 0, 6, 4);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(1);
  grid->setColumnStretch(2, 3);
  grid->setColumnStretch(3, 2);
  grid->setColumnMinimumWidth(1, fontMetrics().horizontalAdvance("attach-position"));
  return section;
}

void Properties::add_row(QWidget* section, const FunctionView& f, EditorKind kind) {
  auto* grid = static_cast<QGridLayout*>(section->layout());
  const int at = grid->rowCount();
  auto row = std::make_unique<Row>();
  const bool wide = kind == EditorKind::lines;        // below its name
  grid->setRowMinimumHeight(at + (wide ? 2 : 1), 0);  // for its parts
  row->at = at, row->of = f, row->name = f.name, row->kind = kind;
  const QString name = text_of(f.name);
  row->diamond = new QToolButton(section);
  row->diamond->setObjectName("diamond_" + name);
  row->diamond->setAutoRaise(true);
  row->diamond->setFocusPolicy(Qt::TabFocus);
  row->called = new QLabel(name, section);
  row->called->setToolTip(text_of(sentence_of(f)));
  row->made = new ShortLabel(section);
  row->made->setObjectName("made_" + name);
  row->made->setEnabled(false);
  row->made->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->editor = make_editor(kind, f, workspace_, section);
  row->editor->setObjectName(name);
  row->editor->setAccessibleName(name);
  row->diamond->setAccessibleName(tr("event of %1").arg(name));
  grid->addWidget(row->diamond, at, 0);
  grid->addWidget(row->called, at, 1);
  wide ? grid->addWidget(row->editor, at + 1, 1, 1, 4) : grid->addWidget(row->editor, at, 2);
  grid->addWidget(row->made, at, 3);
  row->diamond->setIcon(diamond(false, false));
  Row* of = row.get();
  connect(row->diamond, &QToolButton::clicked, this, [this, of] { toggle_event(*of); });
  connect(row->editor, &ValueEditor::looked, this,
          [this, of](int component, const QString& t) { workspace_.look_ahead(lines_for(*of, component, t)); });
  connect(row->editor, &ValueEditor::called_off, this, [this] { workspace_.look_back(); });
  connect(row->editor, &ValueEditor::said, this, [this, of](int component, const QString& t) {
    workspace_.look_back();  // end the preview, because only the real document shows which tracks have events
    const std::vector<std::string> lines = lines_for(*of, component, t);
    // An edit that changes nothing carries out no line.
    const auto then = workspace_.session().look_ahead(lines);
    const bool changes = !lines.empty() && !(then && *then == workspace_.session().document());
    if (changes) workspace_.say(lines);
    refresh();
  });
  add_part_buttons(*row, section);
  rows_.push_back(std::move(row));
}

void Properties::show_row(Row& row, const Value& now) {
  const Document& d = workspace_.document();
  const Target t(leading(), row.of.id);
  row.editor->show_value(now, t, d);
  const MadeBy made = row.of.set || row.of.animated ? made_by(d, t, workspace_.time()) : MadeBy();
  if (row.said != made.said) row.called->setEnabled(row.said = made.said);
  if (row.shown_event != made.event_here || row.shown_events != made.events) {
    row.shown_event = made.event_here, row.shown_events = made.events;
    row.diamond->setIcon(diamond(made.event_here, made.events));
  }
  const std::string name = d.name(t);
  row.diamond->setToolTip(text_of(made.event_here ? "clear " + name + " " + workspace_.when(workspace_.time())
                                                  : "at " + workspace_.when(workspace_.time()) + " " + name + " …"));
  const QString words = words_of(made.sources);
  if (row.made->text() != words) row.made->setText(words);
  row.made->setToolTip(tip_of(made.code.empty() ? words : text_of(made.code)));
  row.unfold->setVisible(made.said || row.parts);
  if (row.parts) row.parts->refresh(t);
}

// Returns a line for each selected object that has the function: it sets the whole value, or one component of it.
std::vector<std::string> Properties::lines_for(const Row& row, int component, const QString& text) const {
  const Document& d = workspace_.session().document();
  const Program* program = &workspace_.program();
  std::vector<std::string> lines;
  for (const ObjectId id : workspace_.selected()) {
    for (const FunctionView& f : functions(d, id)) {
      if (f.name != row.name || f.type != row.of.type) continue;
      Target t(id, f.id);
      std::string value = text.toStdString();
      if (f.type == Type::attachment) {
        if (const auto held = attachment_of(text, d); held && held->parent != id)
          lines.push_back(line_that_holds(d, id, workspace_.time(), *held));
        continue;
      }
      if (component >= 0 && in_components(d, t)) {
        t.component = component;
      } else if (component >= 0) {
        const Value now = program->read(t, workspace_.time());
        const auto* angles = std::get_if<Angles>(&now);
        const auto* vector = std::get_if<Vec3>(&now);
        if (!angles && !vector) continue;
        std::string all;
        const bool here = made_by(d, t, workspace_.time()).event_here;
        for (int i = 0; i < static_cast<int>(f.components.size()); ++i) {
          // A value between events is rounded to what one can see: a micrometre, a thousandth of a degree.
          const double exact = angles ? angles->xyz[i] : (*vector)[i];
          const Value part = here ? exact : angles ? rounded(exact * 180 / pi, 1e-3) * pi / 180 : rounded(exact, 1e-6);
          all += (i > 0 ? " " : "") + (i == component ? value : plain_value(part, Target(id, f.id, i), d));
        }
        value = (angles ? "euler(" : "(") + all + ")";
      }
      if (const auto line = diagram_line(workspace_, id, f.name, value)) {
        lines.push_back(*line);
        continue;
      }
      const bool makes = !spec_of(d.scene(), f.id).by_script && workspace_.makes_events();
      lines.push_back(makes ? line_of_event(d, t, workspace_.time(), value)
                            : line_that_sets(d, t, workspace_.time(), value));
    }
  }
  return lines;
}

// Removes the event at the playhead, or inserts one with the current value.
void Properties::toggle_event(const Row& row) {
  const Document& d = workspace_.document();
  const Target leads(leading(), row.of.id);
  const bool here = made_by(d, leads, workspace_.time()).event_here;
  const std::string when = workspace_.when(workspace_.time());
  std::vector<std::string> lines;
  for (const ObjectId id : workspace_.selected())
    for (const FunctionView& f : functions(d, id)) {
      if (f.name != row.name || f.type != row.of.type) continue;
      const Target t(id, f.id);
      if (here && made_by(d, t, workspace_.time()).event_here) lines.push_back("clear " + d.name(t) + " " + when);
      if (!here)
        lines.push_back(f.type == Type::attachment
                            ? what_holds(d, id, workspace_.time())
                            : "at " + when + " " + d.name(t) + " " +
                                  plain_value(workspace_.program().read(t, workspace_.time()), t, d) +
                                  way_of_new_event(d, t, workspace_.time()));
    }
  workspace_.say(lines);
  refresh();
}

}  // namespace betwixt::studio
