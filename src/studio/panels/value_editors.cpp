// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/value_editors.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include "editor/plain_values.h"
#include "language/values.h"
#include "scene/functions.h"
#include "studio/panels/lines_editor.h"
#include "studio/shell/control_names.h"
#include "studio/shell/number_field.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr int most_names = 2000;      // names offered in a list of objects; the user types others
constexpr qsizetype most_text = 400;  // characters of a value that are shown

QHBoxLayout* row_of(QWidget* w) {
  auto* row = new QHBoxLayout(w);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  return row;
}

class NumbersEditor : public ValueEditor {
 public:
  NumbersEditor(const FunctionView& f, int numbers, QWidget* parent) : ValueEditor(parent), alone_(numbers == 1) {
    auto* row = row_of(this);
    for (int i = 0; i < numbers; ++i) {
      auto* field = new NumberField(this);
      field->setObjectName(alone_ ? QString("value") : text_of(f.components[static_cast<std::size_t>(i)]));
      const bool angle = f.type == Type::angle || f.type == Type::rotation;
      field->set_unit(angle ? "deg" : "");
      if (alone_) field->set_limits(f.low, f.high);
      if (!alone_) field->set_color(i == 0 ? colors().x : i == 1 ? colors().y : colors().z);
      const int component = alone_ ? -1 : i;
      connect(field, &NumberField::looked, this, [=, this](const QString& t) { Q_EMIT looked(component, t); });
      connect(field, &NumberField::said, this, [=, this](const QString& t) { Q_EMIT said(component, t); });
      connect(field, &NumberField::called_off, this, &ValueEditor::called_off);
      row->addWidget(field, 1);
      fields_.push_back(field);
    }
  }
  void show_value(const Value& v, const Target& t, const Document& d) override {
    if (alone_) return fields_[0]->show_value(text_of(plain_value(v, t, d)));
    const auto* angles = std::get_if<Angles>(&v);
    const auto* vector = std::get_if<Vec3>(&v);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const int k = static_cast<int>(i);
      const Target part(t.object, t.function, k);
      if (angles || vector)
        fields_[i]->show_value(text_of(plain_value(Value(angles ? angles->xyz[k] : (*vector)[k]), part, d)));
    }
  }

 private:
  bool alone_;
  std::vector<NumberField*> fields_;
};

// A line of text, passed on when editing is finished.
class Line : public QLineEdit {
 public:
  explicit Line(QWidget* parent, std::function<void(const QString&)> say) : QLineEdit(parent), say_(std::move(say)) {
    setFrame(false);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    connect(this, &QLineEdit::editingFinished, this, [this] {
      if (!isModified()) return;
      setModified(false);
      say_(text());
    });
  }
  void show_value(const QString& t) {
    if ((hasFocus() && isModified()) || t == text()) return;
    show_text(*this, t);
  }

 protected:
  void keyPressEvent(QKeyEvent* e) override {
    if (e->key() != Qt::Key_Escape) return QLineEdit::keyPressEvent(e);
    setModified(false), clearFocus();
  }

 private:
  std::function<void(const QString&)> say_;
};

// Edits points, names, motions and orientations as script text. A very long text is only shown.
class WordsEditor : public ValueEditor {
 public:
  WordsEditor(bool quoted, QWidget* parent)
      : ValueEditor(parent),
        quoted_(quoted),
        line_(new Line(this, [this](const QString& t) { Q_EMIT said(-1, quoted_ ? "\"" + t + "\"" : t); })) {
    line_->setObjectName("value");
    row_of(this)->addWidget(line_);
  }
  void show_value(const Value& v, const Target& t, const Document& d) override {
    const auto* all = std::get_if<Points>(&v);
    const bool many = all && (*all)->size() > 100;
    QString text = many ? tr("%1 points").arg((*all)->size()) : text_of(plain_value(v, t, d));
    const bool cut = text.size() > most_text;
    line_->setReadOnly(many || cut);
    if (quoted_ && text.size() >= 2) text = text.mid(1, text.size() - 2);
    line_->show_value(cut ? text.left(most_text) + "…" : text);
  }

 private:
  bool quoted_;
  Line* line_;
};

class ColorEditor : public ValueEditor {
 public:
  explicit ColorEditor(QWidget* parent)
      : ValueEditor(parent),
        swatch_(new QToolButton(this)),
        line_(new Line(this, [this](const QString& t) { Q_EMIT said(-1, t); })) {
    swatch_->setObjectName("swatch");
    swatch_->setAutoRaise(true);
    swatch_->setToolTip(tr("Choose a colour"));
    line_->setObjectName("value");
    auto* row = row_of(this);
    row->addWidget(swatch_);
    row->addWidget(line_, 1);
    connect(swatch_, &QToolButton::clicked, this, &ColorEditor::choose);
  }
  void show_value(const Value& v, const Target& t, const Document& d) override {
    const auto* c = std::get_if<Color>(&v);
    if (!c) return;
    line_->show_value(text_of(plain_value(v, t, d)));
    const auto part = [](double x) { return static_cast<int>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
    const QColor now(part(c->r), part(c->g), part(c->b));
    if (now == color_ && !swatch_->icon().isNull()) return;
    color_ = now;
    QPixmap pix(64, 64);
    pix.fill(*c == no_color ? Qt::transparent : color_);
    swatch_->setIcon(pix);
  }

 private:
  void choose() {
    auto* dialog = new QColorDialog(color_, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    connect(dialog, &QColorDialog::currentColorChanged, this, [this](const QColor& c) { Q_EMIT looked(-1, c.name()); });
    connect(dialog, &QColorDialog::colorSelected, this, [this](const QColor& c) { Q_EMIT said(-1, c.name()); });
    connect(dialog, &QColorDialog::rejected, this, &ValueEditor::called_off);
    dialog->open();
  }
  QToolButton* swatch_;
  Line* line_;
  QColor color_;
};

class BooleanEditor : public ValueEditor {
 public:
  explicit BooleanEditor(QWidget* parent) : ValueEditor(parent), box_(new QCheckBox(this)) {
    box_->setObjectName("value");
    row_of(this)->addWidget(box_);
    connect(box_, &QCheckBox::clicked, this, [this](bool on) { Q_EMIT said(-1, on ? "on" : "off"); });
  }
  void show_value(const Value& v, const Target&, const Document&) override {
    if (const auto* b = std::get_if<bool>(&v)) box_->setChecked(*b);
  }

 private:
  QCheckBox* box_;
};

class ChoiceEditor : public ValueEditor {
 public:
  ChoiceEditor(std::string_view words, QWidget* parent) : ValueEditor(parent), box_(new QComboBox(this)) {
    box_->setObjectName("value");
    box_->addItems(text_of(words).split('|'));
    box_->setFocusPolicy(Qt::StrongFocus);
    box_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    row_of(this)->addWidget(box_);
    connect(box_, &QComboBox::textActivated, this, [this](const QString& t) { Q_EMIT said(-1, t); });
  }
  void show_value(const Value& v, const Target&, const Document&) override {
    if (const auto* t = std::get_if<Text>(&v)) box_->setCurrentText(text_of(**t));
  }

 private:
  QComboBox* box_;
};

// A list of object names, filled when it opens.
class ObjectBox : public QComboBox {
 public:
  ObjectBox(Workspace& workspace, QStringList first, QWidget* parent)
      : QComboBox(parent), workspace_(workspace), first_(std::move(first)) {
    setEditable(true);
    setInsertPolicy(QComboBox::NoInsert);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    measure_by_text(*this, [this] { setMinimumWidth(5 * fontMetrics().horizontalAdvance('m')); });
  }
  void showPopup() override {
    const QString now = currentText();
    clear();
    addItems(first_);
    for (const ObjectId id : objects(workspace_.document())) {
      if (count() > most_names) break;
      addItem(text_of(workspace_.name(id)));
    }
    setCurrentText(now);
    QComboBox::showPopup();
  }
  void show_value(const QString& t) {
    if (lineEdit()->hasFocus() && lineEdit()->isModified()) return;
    if (t != currentText()) show_text(*lineEdit(), t);
  }

 private:
  Workspace& workspace_;
  QStringList first_;
};

// Calls f(text) after a choice or typed text.
template <class F>
void when_chosen(ObjectBox* box, F f) {
  QObject::connect(box, &QComboBox::textActivated, box, f);
  QObject::connect(box->lineEdit(), &QLineEdit::editingFinished, box, [box, f] {
    if (!box->lineEdit()->isModified()) return;
    box->lineEdit()->setModified(false);
    f(box->currentText());
  });
}

class ObjectEditor : public ValueEditor {
 public:
  ObjectEditor(bool shape, Workspace& workspace, QWidget* parent)
      : ValueEditor(parent), shape_(shape), box_(new ObjectBox(workspace, {"none"}, this)) {
    box_->setObjectName("value");
    row_of(this)->addWidget(box_);
    when_chosen(box_, [this](const QString& t) {
      Q_EMIT said(-1, shape_ && t != "none" && !t.startsWith("shape(") ? "shape(" + t + ")" : t);
    });
  }
  void show_value(const Value& v, const Target& t, const Document& d) override {
    QString text = text_of(plain_value(v, t, d));
    if (shape_ && text.startsWith("shape(")) text = text.mid(6, text.size() - 7);
    box_->show_value(text);
  }

 private:
  bool shape_;
  ObjectBox* box_;
};

// Edits the parent and the kind of attachment; the object keeps its place in the world.
class AttachmentEditor : public ValueEditor {
 public:
  AttachmentEditor(Workspace& workspace, QWidget* parent)
      : ValueEditor(parent), how_(new QComboBox(this)), to_(new ObjectBox(workspace, {}, this)) {
    how_->setObjectName("how");
    to_->setObjectName("value");
    how_->addItems({"detach", "letgo", "hang on", "attach to", "couple to"});
    how_->setFocusPolicy(Qt::StrongFocus);
    auto* row = row_of(this);
    how_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    row->addWidget(how_, 4);
    row->addWidget(to_, 3);
    connect(how_, &QComboBox::activated, this, [this] { say(); });
    when_chosen(to_, [this](const QString&) {
      if (how_->currentIndex() < 2) how_->setCurrentIndex(4);
      say();
    });
  }
  void show_value(const Value& v, const Target&, const Document& d) override {
    const auto* a = std::get_if<Attachment>(&v);
    if (!a || how_->hasFocus()) return;
    how_->setCurrentIndex(static_cast<int>(a->kind));
    to_->show_value(a->parent ? text_of(d.name(a->parent)) : QString());
  }

 private:
  void say() {
    const QString how = how_->currentText(), to = to_->currentText();
    if (how_->currentIndex() < 2) Q_EMIT said(-1, how);
    if (how_->currentIndex() >= 2 && !to.isEmpty()) Q_EMIT said(-1, how + " " + to + " keep-world");
  }
  QComboBox* how_;
  ObjectBox* to_;
};

// Shows the current value of code; the tooltip shows the code.
class CodeEditor : public ValueEditor {
 public:
  explicit CodeEditor(QWidget* parent) : ValueEditor(parent), label_(new QLabel(this)) {
    label_->setObjectName("value");
    label_->setTextFormat(Qt::PlainText);
    label_->setFont(script_font());
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row_of(this)->addWidget(label_);
  }
  void show_value(const Value& v, const Target& t, const Document& d) override {
    label_->setText(text_of(plain_value(v, t, d)).left(most_text));
  }

 private:
  QLabel* label_;
};

// Returns whether a text has lines, or usually has.
bool has_lines(const FunctionView& f, Kind of_object, const Value& now) {
  const auto* text = std::get_if<Text>(&now);
  const bool usually = (of_object == Kind::code && f.name == "text") || (of_object == Kind::diagram && f.name == "of");
  return usually || (text && (**text).find('\n') != std::string::npos);
}

}  // namespace

EditorKind editor_of(const FunctionView& f, Kind of_object, const Value& now, bool code) {
  if (code) return EditorKind::code;
  switch (f.type) {
    case Type::scalar:
    case Type::angle:
      return EditorKind::number;
    case Type::pair:
    case Type::vector:
      return std::holds_alternative<Vec3>(now) ? EditorKind::numbers : EditorKind::words;
    case Type::rotation:
      return std::holds_alternative<Angles>(now) ? EditorKind::numbers : EditorKind::words;
    case Type::color:
      return EditorKind::color;
    case Type::boolean:
      return EditorKind::boolean;
    case Type::text:
      if (!f.words.empty()) return EditorKind::choice;
      return has_lines(f, of_object, now) ? EditorKind::lines : EditorKind::text;
    case Type::shape:
    case Type::aim:
      return EditorKind::object;
    case Type::attachment:
      return EditorKind::attachment;
    default:
      return EditorKind::words;
  }
}

ValueEditor* make_editor(EditorKind kind, const FunctionView& f, Workspace& workspace, QWidget* parent) {
  switch (kind) {
    case EditorKind::number:
      return new NumbersEditor(f, 1, parent);
    case EditorKind::numbers:
      return new NumbersEditor(f, f.type == Type::pair ? 2 : 3, parent);
    case EditorKind::color:
      return new ColorEditor(parent);
    case EditorKind::boolean:
      return new BooleanEditor(parent);
    case EditorKind::choice:
      return new ChoiceEditor(f.words, parent);
    case EditorKind::text:
      return new WordsEditor(true, parent);
    case EditorKind::lines:
      return make_lines_editor(parent);
    case EditorKind::object:
      return new ObjectEditor(f.type == Type::shape, workspace, parent);
    case EditorKind::attachment:
      return new AttachmentEditor(workspace, parent);
    case EditorKind::words:
      return new WordsEditor(false, parent);
    case EditorKind::code:
      return new CodeEditor(parent);
  }
  return nullptr;
}

}  // namespace betwixt::studio
