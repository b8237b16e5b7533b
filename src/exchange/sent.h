// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What programs have sent as bytes, by name. Each content is one file: in a folder of the process, which goes with it,
// or in the folder of a server's history.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "betwixt/sent.h"

namespace betwixt::sent {

inline constexpr std::size_t largest = 64 << 20, all_together = 256 << 20, most_things = 10'000;
inline constexpr std::string_view folder_name = "sent";  // beside a server's script

// Whether bytes with this name and length may come. Errors: name, range.
Status may_come(const std::string& name, std::uint64_t length);
// Does what send_bytes() does. Keeps the file in `folder`, on the disk, unless `folder` is empty.
Result<std::string> take(const std::string& name, std::string_view bytes, const std::filesystem::path& folder);
// Finds what an earlier server has kept in this folder.
void find_again(const std::filesystem::path& folder);

// Returns HASH-NAME for NAME, or the name itself if it has that form already. Errors: name (nothing was sent under it).
Result<std::string> full_name(const std::string& name);
// Returns the file that has the content; nullopt if this process has not got it.
std::optional<std::filesystem::path> file_of(const std::string& full);
// Whether a path is in the folder of the process.
bool is_ours(const std::filesystem::path&);

}  // namespace betwixt::sent
