// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Small pictures of the kinds of objects, drawn as large as they are needed.
#pragma once

#include <QIcon>

#include "betwixt/shape.h"

namespace betwixt::studio {

QIcon kind_icon(Kind);
// Of an object that is seen, or not.
QIcon eye_icon(bool open);

}  // namespace betwixt::studio
