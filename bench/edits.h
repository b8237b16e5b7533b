// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Measures a change of one event in a document of a million: the command, written to a file before the answer, the
// program and the frame. Measures the same in plain code.
void edits(int rounds);
