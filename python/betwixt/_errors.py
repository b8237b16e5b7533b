# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Errors and warnings of scripts, with their places and suggestions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Sequence

if TYPE_CHECKING:
    from ._core import Diagnostic


class Error(Exception):
    """An error in a script, in a call, or of the machine. `str` formats it as the program does: with the line, a caret
    below the place, and a hint.

    `message`, `hint`, `file`, `line`, `column` (both from 1; line 0 if the place is unknown), `text` (of the line) and
    `code` ("syntax", "name", "type", "range", "file" or "machine") are those of the first error. `diagnostics` has all
    errors and warnings.
    """

    def __init__(self, diagnostics: Sequence[Diagnostic]) -> None:
        super().__init__(diagnostics)
        self.diagnostics = list(diagnostics)
        first = next(d for d in self.diagnostics if d.severity == "error")
        self.code: str = first.code
        self.message: str = first.message
        self.hint: str = first.hint
        self.file: str = first.file
        self.line: int = first.line
        self.column: int = first.column
        self.text: str = first.text

    def __str__(self) -> str:
        return "\n".join(str(d) for d in self.diagnostics)


class Warning(UserWarning):  # noqa: A001 — the name is betwixt.Warning, like betwixt.Error
    """A problem with which the film can still be made."""
