// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "betwixt/contacts.h"

namespace betwixt {

// Runs the swept test on two sets of boxes.
Contacts swept(const Contacts& before, const Contacts& after, const ContactOptions&);

}  // namespace betwixt
