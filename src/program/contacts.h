// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "betwixt/contacts.h"
#include "program/compiled.h"

namespace betwixt {

// Runs the swept test on two sets of boxes.
Contacts swept(const Contacts& before, const Contacts& after, const ContactOptions&);

// Returns the contacts at a time, which the film's procedures may read.
std::shared_ptr<const Contacts> contacts(const Program::Compiled&, Time, Asking&);

}  // namespace betwixt
