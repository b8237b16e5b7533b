// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Short functions that make motions from texts.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "betwixt/algebra.h"

namespace betwixt {

inline Motion parsed(const std::string& text) {
  const auto motion = parse_motion(text);
  EXPECT_TRUE(motion) << text << ": " << (motion ? "" : motion.error().message);
  return motion ? *motion : Motion{};
}

}  // namespace betwixt
