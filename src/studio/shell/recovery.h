// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The question after a crash: it shows how the saved file and the unsaved work differ.
#pragma once

#include <QDialog>
#include <memory>
#include <optional>
#include <string>
#include <thread>

class QLabel;
class QPushButton;
class QTextBrowser;

namespace betwixt::studio {

// Returns the text that recovering would give, without a change to the script or its journal; nullopt if that fails.
// Works on copies beside them.
// `nameless_journal` is that of a film without a file, if it is not the usual one.
std::optional<std::string> recovered_text(const std::string& script, const std::string& nameless_journal = {});

class Recovery : public QDialog {
  Q_OBJECT
 public:
  // `question` says how much is not saved.
  Recovery(const std::string& script, const std::string& question, QWidget* parent = nullptr,
           const std::string& nameless_journal = {});
  ~Recovery() override;
  // "recover", "discard", or nothing if the user wants to decide later.
  const std::optional<std::string>& chosen() const { return chosen_; }
  bool is_read() const { return read_; }

 Q_SIGNALS:
  void came();  // by the thread that reads

 private:
  void show_difference();
  void save_as();

  const std::string script_, nameless_journal_;
  std::string saved_;
  std::optional<std::string> recovered_;
  std::optional<std::string> chosen_;
  QLabel* counts_;
  QTextBrowser* lines_;
  QPushButton* save_;
  bool read_ = false;
  std::thread reader_;
};

}  // namespace betwixt::studio
