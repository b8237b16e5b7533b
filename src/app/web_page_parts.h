// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts that pages of films share.
#pragma once

#include <string>
#include <string_view>

#include "app/web_page.h"

namespace betwixt {

// `flags`: attributes of the player, as in " controls loop".
std::string player_markup(const PageFilm&, const PageOptions&, std::string_view flags);
std::string files_markup(const PageFiles&);

}  // namespace betwixt
