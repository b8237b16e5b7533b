// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A temporary folder with the files of a test.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/folder.h"

namespace betwixt {

class Files : public testing::Test {
 protected:
  std::string at(const std::string& name) const { return folder_ / name; }
  std::string put(const std::string& name, const std::string& content) const { return folder_.put(name, content); }
  const Folder folder_;
};

}  // namespace betwixt
