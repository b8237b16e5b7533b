// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The fast path for the rows of long scripts: a time, plain numbers and perhaps a twerper. Every other row, and every
// row with an error, is left to the reader, so that both give the same events and errors.
#pragma once

#include "commands/command.h"

namespace betwixt {

// Reads the plain rows that follow each other at the cursor, which is at the start of an indented line, and puts their
// events on the tracks of the open sheet. Stops at the start of the first other line, or after a few hundred rows, so
// that the caller can report progress. Returns whether it has read any.
bool plain_rows(Command&);

}  // namespace betwixt
