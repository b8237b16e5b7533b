// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/about.h"

#include <QMessageBox>

#include "studio/shell/text_of.h"

// Q_INIT_RESOURCE must be outside of namespaces.
static void init_icons() { Q_INIT_RESOURCE(icons); }

namespace betwixt::studio {

QIcon program_icon() {
  init_icons();
  return QIcon(":/icons/betwixt.png");
}

QString about_words() {
  return QObject::tr(
             "Betwixt %1\n\nCopyright 2026 The Betwixt authors. You may use, change and pass on Betwixt under "
             "the terms of the Apache License, version 2.0.\n\nThe studio uses Qt %2, under the terms of the "
             "GNU Lesser General Public License, version 3.")
      .arg(text_of(BETWIXT_VERSION), text_of(qVersion()));
}

void open_about(QWidget* over) {
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, QObject::tr("About Betwixt"), about_words(), QMessageBox::Close, over);
  box->setObjectName("about");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  const int side = 4 * box->fontMetrics().height();
  box->setIconPixmap(program_icon().pixmap(side, side));
  box->open();
}

}  // namespace betwixt::studio
