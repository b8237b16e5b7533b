// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One event changed in a document of a million: the command, kept in a file before it is answered, the program, the
// frame. Beside it the same by plain code.
void edits(int rounds);
