// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/poses/trial_dialog.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>

#include "studio/poses/curve_field.h"

namespace betwixt::studio {
namespace {

// Shows the lines in the picture after each change of the controls, and the film itself at the end.
class Trial : public QDialog {
 public:
  Trial(Workspace& workspace, QWidget* parent, const QString& title, std::function<Lines()> lines)
      : QDialog(parent), workspace_(workspace), lines_(std::move(lines)), rows_(new QVBoxLayout(this)) {
    setWindowTitle(title);
  }
  QVBoxLayout& rows() { return *rows_; }
  void look() {
    workspace_.look_back();
    if (const Lines lines = lines_(); !lines.empty()) workspace_.look_ahead(lines);
  }
  bool accepted() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    rows_->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    stand_aside();
    look();
    const bool is = exec() == Accepted;
    workspace_.look_back();
    return is;
  }

 private:
  // Stands in the lower right corner of the window, so that the picture shows what the answers do.
  void stand_aside() {
    const QWidget* around = parentWidget() ? parentWidget()->window() : nullptr;
    if (!around) return;
    adjustSize();
    const int margin = fontMetrics().height();
    move(around->frameGeometry().bottomRight() - QPoint(width() + margin, height() + 3 * margin));
  }

  Workspace& workspace_;
  const std::function<Lines()> lines_;
  QVBoxLayout* rows_;
};

// Curves to begin with, as in CSS.
constexpr std::pair<const char*, std::array<double, 4>> known_curves[] = {
    {QT_TRANSLATE_NOOP("betwixt::studio::RetimeCurve", "linear"), {0, 0, 1, 1}},
    {QT_TRANSLATE_NOOP("betwixt::studio::RetimeCurve", "slow at the start"), {0.42, 0, 1, 1}},
    {QT_TRANSLATE_NOOP("betwixt::studio::RetimeCurve", "slow at the end"), {0, 0, 0.58, 1}},
    {QT_TRANSLATE_NOOP("betwixt::studio::RetimeCurve", "slow at both ends"), {0.42, 0, 0.58, 1}},
    {QT_TRANSLATE_NOOP("betwixt::studio::RetimeCurve", "slow in the middle"), {0, 0.42, 1, 0.58}},
};

}  // namespace

std::optional<double> ask_share(Workspace& workspace, QWidget* parent, const QString& title, int low, int high,
                                int start, const std::function<Lines(double)>& lines) {
  auto* slider = new QSlider(Qt::Horizontal);
  const auto share = [slider] { return slider->value() / 100.0; };
  Trial trial(workspace, parent, title, [&] { return lines(share()); });
  auto* number = new QSpinBox;
  number->setRange(low, high), number->setSuffix(" %"), number->setValue(start);
  slider->setRange(low, high), slider->setPageStep(10), slider->setValue(start);
  slider->setMinimumWidth(20 * trial.fontMetrics().height());
  for (QWidget* control : {static_cast<QWidget*>(slider), static_cast<QWidget*>(number)})
    control->setAccessibleName(QObject::tr("Share"));
  auto* row = new QHBoxLayout;
  row->addWidget(slider, 1), row->addWidget(number);
  trial.rows().addLayout(row);
  QObject::connect(slider, &QSlider::valueChanged, number, &QSpinBox::setValue);
  QObject::connect(number, &QSpinBox::valueChanged, slider, &QSlider::setValue);
  QObject::connect(slider, &QSlider::valueChanged, &trial, &Trial::look);
  slider->setFocus();
  if (!trial.accepted()) return std::nullopt;
  return share();
}

std::optional<double> ask_tolerance(Workspace& workspace, QWidget* parent, const QString& title, double start,
                                    const std::function<QString(double)>& words,
                                    const std::function<Lines(double)>& lines) {
  auto* number = new QDoubleSpinBox;
  const auto share = [number] { return number->value() / 100; };
  Trial trial(workspace, parent, title, [&] { return lines(share()); });
  number->setObjectName("tolerance"), number->setAccessibleName(QObject::tr("Tolerance"));
  number->setRange(0, 100), number->setDecimals(3), number->setSuffix(QObject::tr(" % of the range"));
  number->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType), number->setValue(100 * start);
  auto* label = new QLabel;
  label->setObjectName("effect");
  const auto tell = [&] { label->setText(words(share())); };
  trial.rows().addWidget(number), trial.rows().addWidget(label);
  tell();
  QObject::connect(number, &QDoubleSpinBox::valueChanged, &trial, [&] { tell(), trial.look(); });
  number->setFocus(), number->selectAll();
  if (!trial.accepted()) return std::nullopt;
  return share();
}

std::optional<std::array<double, 4>> ask_curve(Workspace& workspace, QWidget* parent, const QString& title,
                                               const std::function<Lines(const std::array<double, 4>&)>& lines) {
  auto* field = new CurveField;
  Trial trial(workspace, parent, title, [&] { return lines(field->curve()); });
  auto* known = new QComboBox;
  known->setAccessibleName(QObject::tr("Curve"));
  for (const auto& [name, curve] : known_curves)
    known->addItem(QCoreApplication::translate("betwixt::studio::RetimeCurve", name));
  known->setCurrentIndex(3);
  field->set_curve(known_curves[3].second);
  trial.rows().addWidget(known), trial.rows().addWidget(field, 1);
  QObject::connect(known, &QComboBox::activated, field, [field](int i) { field->set_curve(known_curves[i].second); });
  QObject::connect(field, &CurveField::changed, &trial, &Trial::look);
  if (!trial.accepted()) return std::nullopt;
  return field->curve();
}

}  // namespace betwixt::studio
