// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The precompiled header: headers that most tests include. Each test still includes every header that it uses.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <random>

#include "../cmake/often.h"
