// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// HarfBuzz's options for pages: formulas need the tables of mathematical fonts.
#pragma once
#undef HB_NO_MATH
#undef HB_NO_LAYOUT_RARELY_USED
