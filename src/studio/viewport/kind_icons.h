// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Icons of the kinds of objects, drawn as vectors for any size.
#pragma once

#include <QIcon>

#include "betwixt/shape.h"

namespace betwixt::studio {

QIcon kind_icon(Kind);
// Returns the icon of an object that is shown or hidden.
QIcon eye_icon(bool open);

}  // namespace betwixt::studio
