// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/sent.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <mutex>
#include <vector>

#include "base/files.h"
#include "base/names.h"
#include "base/process_folder.h"
#include "base/sha256.h"
#include "betwixt/picture.h"
#include "exchange/drawing.h"
#include "exchange/font_face.h"
#include "exchange/meshes.h"
#include "exchange/pictures.h"
#include "exchange/scene_file.h"
#include "exchange/sounds.h"

namespace betwixt::sent {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t hash_digits = 16, longest_name = 64;

struct Store {
  std::mutex mutex;
  ProcessFolder folder{"sent"};
  std::map<std::string, fs::path, std::less<>> files;      // by full name
  std::map<std::string, std::string, std::less<>> newest;  // full names by name
  std::uint64_t bytes = 0;
};
Store& store() {
  static Store all;
  return all;
}

enum class Content { picture, mesh, scene, drawing, sound, font };
struct Ending {
  std::string_view ending;
  Content content;
};
constexpr std::array endings{
    Ending{"png", Content::picture}, Ending{"jpg", Content::picture}, Ending{"jpeg", Content::picture},
    Ending{"obj", Content::mesh},    Ending{"stl", Content::mesh},    Ending{"glb", Content::scene},
    Ending{"gltf", Content::scene},  Ending{"svg", Content::drawing}, Ending{"wav", Content::sound},
    Ending{"ttf", Content::font},    Ending{"otf", Content::font},    Ending{"mp3", Content::sound},
    Ending{"ogg", Content::sound},   Ending{"flac", Content::sound},
};
const Ending* find_ending(const std::string& name) {
  const std::string end = ending(name);
  const auto found = std::find_if(endings.begin(), endings.end(), [&](const Ending& e) { return e.ending == end; });
  return found == endings.end() ? nullptr : &*found;
}

bool plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

bool is_full(std::string_view name) {
  return name.size() > hash_digits + 1 && name[hash_digits] == '-' &&
         name.substr(0, hash_digits).find_first_not_of("0123456789abcdef") == name.npos;
}

Status check_name(const std::string& name) {
  const std::string shown = name.substr(0, longest_name);
  if (name.empty() || name.size() > longest_name || name[0] == '.' || name[0] == '-' || is_full(name) ||
      !std::all_of(name.begin(), name.end(), plain))
    return fail(ErrorCode::name, fmt::format("'{}' cannot be the name of something sent", shown),
                "a name has at most 64 letters a-z, digits, '-', '_' and '.', as in logo.png");
  if (!find_ending(name))
    return fail(ErrorCode::name, fmt::format("the ending of '{}' does not say what the bytes are", shown),
                "endings are png, jpg, jpeg, obj, stl, glb, gltf, svg, wav, mp3, ogg, flac, ttf and otf");
  return Nothing{};
}

std::string full_name_of(const std::string& name, std::string_view bytes) {
  std::string out;
  for (const std::uint8_t byte : sha256(bytes))
    if (out.size() < hash_digits) out += fmt::format("{:02x}", byte);
  return out + "-" + name;
}

template <class T>
Status whether(const Result<T>& read) {
  if (!read) return read.error();
  return Nothing{};
}

// Reads the file as a script would: in the parser's process.
Status check_content(Content content, const std::string& path) {
  const MayRead only = [&](const std::string& asked) { return asked == path; };
  switch (content) {
    case Content::picture:
      return whether(load_picture(path, false));
    case Content::mesh:
      return whether(load_mesh(path, only));
    case Content::scene:
      return whether(load_scene(path, only, false));
    case Content::drawing:
      return whether(load_drawing(path, only, false));
    case Content::sound:
      return whether(read_sound(path));
    case Content::font:
      return whether(load_font(path));
  }
  return Nothing{};
}

Status has_room(const Store& all, std::uint64_t length) {
  if (all.files.size() >= most_things)
    return fail(ErrorCode::range, fmt::format("at most {} things can be sent", most_things));
  if (all.bytes + length > all_together)
    return fail(ErrorCode::range, fmt::format("all that is sent can have at most {} MiB together", all_together >> 20));
  return Nothing{};
}

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size()) text.replace(at, what.size(), by);
}

}  // namespace

Status may_come(const std::string& name, std::uint64_t length) {
  if (Status s = check_name(name); !s) return s;
  if (length > largest) return fail(ErrorCode::range, fmt::format("'{}' has more than {} MiB", name, largest >> 20));
  Store& all = store();
  const std::lock_guard lock(all.mutex);
  return has_room(all, length);
}

Result<std::string> take(const std::string& name, std::string_view bytes, const fs::path& folder) {
  if (Status s = check_name(name); !s) return s.error();
  if (bytes.size() > largest)
    return fail(ErrorCode::range, fmt::format("'{}' has more than {} MiB", name, largest >> 20));
  const std::string full = full_name_of(name, bytes);
  Store& all = store();
  fs::path own;
  {
    const std::lock_guard lock(all.mutex);
    std::error_code ignored;
    if (const auto known = all.files.find(full); known != all.files.end() && fs::exists(known->second, ignored) &&
                                                 (folder.empty() || known->second.parent_path() == folder)) {
      all.newest[name] = full;
      return "@" + full;
    }
    if (Status s = has_room(all, bytes.size()); !s) return s.error();
    const auto got = all.folder.get();
    if (!got) return got.error();
    own = *got / full;
  }
  // Checked in our own folder first: a refused content leaves nothing in the folder of a history.
  if (const int reason = put_file(own.string(), bytes); reason != 0) return system_error(reason, "write", own.string());
  std::error_code ignored;
  if (Status s = check_content(find_ending(name)->content, own.string()); !s) {
    Error e = s.error();
    replace_all(e.message, own.string(), "@" + name);
    fs::remove(own, ignored);
    return e;
  }
  fs::path place = own;
  if (!folder.empty()) {
    place = folder / full;
    fs::create_directory(folder, ignored);
    if (const int reason = put_file(place.string(), bytes, {.on_disk = true}); reason != 0)
      return system_error(reason, "write", place.string());
    fs::remove(own, ignored);
  }
  const std::lock_guard lock(all.mutex);
  if (all.files.insert_or_assign(full, place).second) all.bytes += bytes.size();
  all.newest[name] = full;
  return "@" + full;
}

void find_again(const fs::path& folder) {
  struct Found {
    fs::file_time_type written;
    fs::path path;
    std::uint64_t bytes;
  };
  std::vector<Found> found;
  std::error_code why;
  for (const auto& entry : fs::directory_iterator(folder, why)) {
    const std::string name = entry.path().filename().string();
    if (!is_full(name) || !check_name(name.substr(hash_digits + 1)) || !entry.is_regular_file(why)) continue;
    found.push_back({entry.last_write_time(why), entry.path(), entry.file_size(why)});
    if (found.size() >= most_things) break;
  }
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.written < b.written; });
  Store& all = store();
  const std::lock_guard lock(all.mutex);
  for (const Found& f : found) {
    const std::string full = f.path.filename().string();
    if (all.files.insert_or_assign(full, f.path).second) all.bytes += f.bytes;
    all.newest[full.substr(hash_digits + 1)] = full;
  }
}

Result<std::string> full_name(const std::string& name) {
  if (is_full(name) && std::all_of(name.begin(), name.end(), plain)) return name;
  Store& all = store();
  const std::lock_guard lock(all.mutex);
  if (const auto found = all.newest.find(name); found != all.newest.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [known, full] : all.newest) names.push_back(known);
  return fail(ErrorCode::name, fmt::format("nothing was sent under the name '{}'", name.substr(0, longest_name)),
              did_you_mean(name.substr(0, longest_name), names));
}

std::optional<fs::path> file_of(const std::string& full) {
  Store& all = store();
  const std::lock_guard lock(all.mutex);
  const auto found = all.files.find(full);
  if (found == all.files.end()) return std::nullopt;
  return found->second;
}

bool is_ours(const fs::path& path) {
  Store& all = store();
  const std::lock_guard lock(all.mutex);
  return !all.folder.path().empty() && path.parent_path() == all.folder.path();
}

}  // namespace betwixt::sent

namespace betwixt {

Result<std::string> send_bytes(const std::string& name, std::string_view bytes) { return sent::take(name, bytes, {}); }

}  // namespace betwixt
