// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Assets: the files in the film's folder from which objects are made, and the looks of the language. Both are dragged
// into the picture.
#pragma once

#include <QFileSystemWatcher>
#include <QListWidget>
#include <QWidget>

#include "studio/assets/asset_files.h"
#include "studio/assets/small_pictures.h"
#include "studio/shell/workspace.h"

class QLabel;
class QLineEdit;
class QTabWidget;

namespace betwixt::studio {

// A list of pictures with names. What is dragged out of it are the data of its items.
class AssetList : public QListWidget {
  Q_OBJECT
 public:
  enum Role { file = Qt::UserRole, look };
  explicit AssetList(QWidget* parent = nullptr);
  void show_only(const QString& part);  // of a name

 Q_SIGNALS:
  void view_changed();

 protected:
  QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
  void scrollContentsBy(int dx, int dy) override;
  void resizeEvent(QResizeEvent*) override;
};

class AssetPanel : public QWidget {
  Q_OBJECT
 public:
  explicit AssetPanel(Workspace&, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {24 * fontMetrics().horizontalAdvance('m'), 300}; }

 Q_SIGNALS:
  void chosen(const QString& file);  // by a double click

 protected:
  void showEvent(QShowEvent*) override;

 private:
  void scan();
  void watch(const QStringList& files);
  void list(const QStringList& files);
  void add_looks();
  void show_pictures();
  void give_look(const QString& look);

  Workspace& workspace_;
  SmallPictures pictures_;
  FolderScan scan_;
  QLineEdit* search_;
  QTabWidget* tabs_;
  AssetList *files_, *looks_;
  QLabel* state_;
  QWidget* says_ = nullptr;  // around it
  QString folder_;
  QFileSystemWatcher watcher_;
  QTimer settles_;  // many files may change at once
  QStringList listed_;
};

}  // namespace betwixt::studio
