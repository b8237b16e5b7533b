// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The videos of films in pages.
#pragma once

#include "app/web_page.h"
#include "betwixt/document.h"

namespace betwixt {

// Adds the pictures of the film's videos that it shows, in place of their files, as far as these are no sounds too.
Status add_videos(PageFilm&, const Document&);

}  // namespace betwixt
