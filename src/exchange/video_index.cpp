// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/video_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>

#include "betwixt/time.h"
#include "exchange/jailed_reader.h"

namespace betwixt {
namespace {

Error no_video(const std::string& path, std::string_view why) {
  return fail(ErrorCode::file,
              fmt::format("{} is broken or not a video: {}", path, why.empty() ? "it has no pictures" : why));
}

// A line of ffprobe's compact form: its sort, then `|key=value` each.
std::string_view value_in(std::string_view line, std::string_view key) {
  for (std::size_t at = line.find('|'); at != line.npos; at = line.find('|', at + 1)) {
    const std::string_view rest = line.substr(at + 1);
    if (rest.size() > key.size() && rest.starts_with(key) && rest[key.size()] == '=')
      return rest.substr(key.size() + 1, rest.find('|') - std::min(rest.find('|'), key.size() + 1));
  }
  return {};
}
std::optional<std::int64_t> whole(std::string_view text) {
  std::int64_t n = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), n);
  const bool sane = failed == std::errc() && end == text.data() + text.size() && std::abs(n) < (std::int64_t{1} << 56);
  return sane ? std::optional(n) : std::nullopt;
}
// Reads "24000/1001" or "4:3". Leaves both if it is none, or not positive.
void ratio(std::string_view text, std::int64_t& num, std::int64_t& den) {
  const auto at = text.find_first_of("/:");
  if (at == text.npos) return;
  const auto a = whole(text.substr(0, at)), b = whole(text.substr(at + 1));
  constexpr std::int64_t most = std::int64_t{1} << 31;
  if (a && b && *a > 0 && *b > 0 && *a < most && *b < most) num = *a, den = *b;
}

// The decoder that keeps the opacity of a file, which others leave out.
std::string decoder_of(std::string_view line) {
  if (value_in(line, "tag:alpha_mode") != "1" && value_in(line, "tag:ALPHA_MODE") != "1") return {};
  const std::string_view codec = value_in(line, "codec_name");
  return codec == "vp9" ? "libvpx-vp9" : codec == "vp8" ? "libvpx" : "";
}

void take_stream(std::string_view line, VideoIndex& to) {
  const auto width = whole(value_in(line, "width")), height = whole(value_in(line, "height"));
  to.width = static_cast<int>(std::clamp<std::int64_t>(width.value_or(0), 0, 1 << 24));
  to.height = static_cast<int>(std::clamp<std::int64_t>(height.value_or(0), 0, 1 << 24));
  std::int64_t across = 1, down = 1;
  ratio(value_in(line, "sample_aspect_ratio"), across, down);
  ratio(value_in(line, "time_base"), to.clock_num, to.clock_den);
  ratio(value_in(line, "avg_frame_rate"), to.rate_num, to.rate_den);
  to.decoder = decoder_of(line);
  const std::string_view space = value_in(line, "color_space");
  to.vague_colors = space.empty() || space == "unknown" || space == "N/A";
  const auto turned = whole(value_in(line, "rotation"));
  if (turned && std::abs(*turned) % 180 == 90) std::swap(to.width, to.height), std::swap(across, down);
  const double shape = static_cast<double>(across) / static_cast<double>(down);
  to.aspect = to.height > 0 ? std::clamp(to.width * shape / to.height, 1e-3, 1e3) : 1;
}

struct Packet {
  std::int64_t time = 0, length = 0;
  bool key = false;
};

// Removes what cannot be seen: of several pictures at one time, all but one.
void put_in_order(std::vector<Packet>& all, VideoIndex& to) {
  std::stable_sort(all.begin(), all.end(), [](const Packet& a, const Packet& b) { return a.time < b.time; });
  all.erase(std::unique(all.begin(), all.end(), [](const Packet& a, const Packet& b) { return a.time == b.time; }),
            all.end());
  to.times.clear(), to.keys.clear();
  for (const Packet& p : all) {
    if (p.key) to.keys.push_back(to.times.size());
    to.times.push_back(p.time);
  }
  if (all.empty()) return;
  const std::int64_t usual =
      all.size() > 1 ? (all.back().time - all.front().time) / static_cast<std::int64_t>(all.size() - 1) : 1;
  to.last = std::max<std::int64_t>(all.back().length > 0 ? all.back().length : usual, 1);
}

std::vector<std::string> probe_call(const std::string& path, bool decode) {
  std::vector<std::string> words{"-v",
                                 "error",
                                 "-select_streams",
                                 "V:0",
                                 "-show_entries",
                                 "stream=codec_name,width,height,sample_aspect_ratio,time_base,avg_frame_rate,"
                                 "color_space:stream_tags=alpha_mode:stream_side_data=rotation:"};
  words.back() += decode ? "frame=best_effort_timestamp" : "packet=pts,duration,flags";
  words.insert(words.end(), {"-of", "compact"});
  for (std::string& word : arguments_for_reading(path)) words.push_back(std::move(word));
  return words;
}

// Runs ffprobe and returns what it says. With `decode`, it decodes all pictures.
Result<std::string> probed(const std::string& path, bool decode, const ParserCeilings& most, std::string& complaint) {
  constexpr std::size_t longest = 128 * most_video_pictures;
  JailedReader program;
  if (Status s = program.start("ffprobe", probe_call(path, decode), path, most, "videos"); !s) return s.error();
  std::string lines;
  std::vector<char> some(1 << 16);
  while (const std::size_t n = program.read(some)) {
    lines.append(some.data(), n);
    if (lines.size() > longest)
      return fail(ErrorCode::range, fmt::format("{} has more than {} pictures", path, most_video_pictures));
  }
  std::string why;
  const Status end = program.finish([&](const std::string& reason) { return no_video(path, why = reason); });
  if (!end) return end.error();
  complaint = program.said();
  return lines;
}

}  // namespace

bool take_lines(const std::string& lines, VideoIndex& to) {
  std::vector<Packet> packets;
  bool streams = false, unknown = false;
  for (std::size_t at = 0; at < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', at), lines.size());
    const std::string_view line = std::string_view(lines).substr(at, end - at);
    at = end + 1;
    if (line.starts_with("stream|")) take_stream(line, to), streams = true;
    const bool frame = line.starts_with("frame|");
    if (!frame && !line.starts_with("packet|")) continue;
    auto time = whole(value_in(line, frame ? "best_effort_timestamp" : "pts"));
    // The last pictures that a decoder gives may lack a time: they follow as those before them did.
    if (const std::size_t n = packets.size(); frame && !time && n > 1)
      time = 2 * packets[n - 1].time - packets[n - 2].time;
    const std::string_view flags = value_in(line, "flags");
    if (flags.find('D') != flags.npos) continue;  // it is decoded but not shown
    unknown |= !time;
    const auto length = frame ? std::nullopt : whole(value_in(line, "duration"));
    if (time) packets.push_back({*time, length.value_or(0), !frame && flags.starts_with('K')});
  }
  put_in_order(packets, to);
  if (unknown) to.keys.clear(), to.times.clear();
  return streams;
}

Result<VideoIndex> index_video(const std::string& path, const ParserCeilings& most) {
  VideoIndex index;
  const auto lines = probed(path, false, most, index.complaint);
  if (!lines) return lines.error();
  if (!take_lines(*lines, index)) return no_video(path, {});
  if (index.width > most_video_side || index.height > most_video_side)
    return fail(ErrorCode::range, fmt::format("{} has {}x{} pixels; the limit for videos is {} a side", path,
                                              index.width, index.height, most_video_side));
  if (index.times.empty()) {  // some files say when a picture is decoded, but not when it is shown
    const auto decoded = probed(path, true, most, index.complaint);
    if (!decoded) return decoded.error();
    take_lines(*decoded, index);
  }
  if (index.times.empty() || index.width < 1 || index.height < 1 || index.clock_num < 1) return no_video(path, {});
  if (index.times.size() > most_video_pictures)
    return fail(ErrorCode::range, fmt::format("{} has more than {} pictures", path, most_video_pictures));
  return index;
}

VideoTimes times_of(const VideoIndex& index) {
  constexpr double flicks = static_cast<double>(flicks_per_second);
  const double step = flicks * static_cast<double>(index.clock_num) / static_cast<double>(index.clock_den);
  const auto at = [&](std::int64_t steps) { return std::llround(static_cast<double>(steps) * step); };
  VideoTimes out;
  for (const std::int64_t t : index.times) out.begins.push_back(at(t - index.times.front()));
  out.end = at(index.times.back() - index.times.front() + index.last);
  // The clock of some files is coarse, and times are rounded to it. If they are those of an even rate, its are exact.
  constexpr double least = flicks / 1e6, most = flicks / 2000;
  out.slack = std::llround(std::clamp(step / 2, least, most));
  const double even =
      index.rate_num > 0 ? flicks * static_cast<double>(index.rate_den) / static_cast<double>(index.rate_num) : 0;
  const double off = std::min(step, 2 * most);
  for (std::size_t k = 0; k < out.begins.size(); ++k)
    if (std::abs(static_cast<double>(out.begins[k]) - static_cast<double>(k) * even) > off) return out;
  if (even <= 0) return out;
  for (std::size_t k = 0; k < out.begins.size(); ++k) out.begins[k] = std::llround(static_cast<double>(k) * even);
  const double end = static_cast<double>(out.begins.size()) * even;
  if (std::abs(static_cast<double>(out.end) - end) <= off) out.end = std::llround(end);
  out.slack = std::llround(least);
  return out;
}

}  // namespace betwixt
