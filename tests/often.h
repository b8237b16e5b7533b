// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Precompiled: what most tests include. A test includes what it needs all the same.
#pragma once

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fstream>
#include <random>

#include "../cmake/often.h"
