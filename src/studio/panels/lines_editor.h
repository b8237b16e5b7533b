// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// An editor for texts of several lines, such as code and diagrams.
#pragma once

#include "studio/panels/value_editors.h"

namespace betwixt::studio {

// The text is passed on by ctrl-Return, and when the focus leaves. Escape brings the old one back.
ValueEditor* make_lines_editor(QWidget* parent);

}  // namespace betwixt::studio
