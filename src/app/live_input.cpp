// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/live_input.h"

#include <RtMidi.h>
#include <fmt/format.h>
#include <lo/lo.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace betwixt {
namespace {

constexpr int deepest_bundle = 8;
constexpr std::size_t most_messages = 4096;  // of one packet
constexpr int most_packets = 2048;           // of one poll

// Returns half the distance to the next number of four bytes.
double half_step(float f) {
  return 0.5 * (static_cast<double>(std::nextafter(std::abs(f), std::numeric_limits<float>::infinity())) - std::abs(f));
}

// Reads one message; liblo checks it against its type tags.
bool read_message(std::span<const std::uint8_t> bytes, std::vector<LiveMessage>& out) {
  if (bytes.size() < 4 || bytes[0] != '/' || std::find(bytes.begin(), bytes.end(), 0) == bytes.end()) return false;
  std::vector<std::uint8_t> own(bytes.begin(), bytes.end());  // liblo changes the bytes
  int why = 0;
  const std::unique_ptr<void, void (*)(lo_message)> message(lo_message_deserialise(own.data(), own.size(), &why),
                                                            lo_message_free);
  if (!message) return false;
  LiveMessage m;
  m.address = reinterpret_cast<const char*>(bytes.data());
  const std::string_view types = lo_message_get_types(message.get());
  lo_arg** values = lo_message_get_argv(message.get());
  for (std::size_t i = 0; i < types.size(); ++i) {
    const auto type = static_cast<lo_type>(types[i]);
    if (lo_is_numerical_type(type)) {
      m.numbers.push_back(static_cast<double>(lo_hires_val(type, values[i])));
      m.within.push_back(type == LO_FLOAT ? half_step(values[i]->f) : 0);
    }
    if (type == LO_TRUE || type == LO_FALSE) m.numbers.push_back(type == LO_TRUE ? 1 : 0), m.within.push_back(0);
    if ((type == LO_STRING || type == LO_SYMBOL) && !m.text) m.text = &values[i]->s;
  }
  out.push_back(std::move(m));
  return true;
}

// Reads "#bundle", a time, then elements: a length and a message or a bundle.
bool read_element(std::span<const std::uint8_t> bytes, int depth, std::vector<LiveMessage>& out) {
  constexpr std::string_view bundle{"#bundle", 8};
  if (out.size() >= most_messages || depth > deepest_bundle) return false;
  if (bytes.size() < 16 || std::memcmp(bytes.data(), bundle.data(), bundle.size()) != 0)
    return read_message(bytes, out);
  for (bytes = bytes.subspan(16); !bytes.empty();) {
    if (bytes.size() < 4) return false;
    std::size_t length = 0;
    for (const std::uint8_t b : bytes.first(4)) length = length << 8 | b;
    if (length > bytes.size() - 4 || !read_element(bytes.subspan(4, length), depth + 1, out)) return false;
    bytes = bytes.subspan(4 + length);
  }
  return true;
}

// Opens all MIDI ports that it can. A missing sequencer is no error; exceptions of RtMidi do not leave this class.
class Midi {
 public:
  Midi() {
    if (::access("/dev/snd/seq", R_OK | W_OK) != 0) return;  // otherwise ALSA prints an error over the picture
    try {
      const unsigned ports = quiet()->getPortCount();
      for (unsigned i = 0; i < std::min(ports, 16u); ++i) {
        auto in = quiet();
        in->openPort(i, "controls");
        ports_.push_back(std::move(in));
      }
    } catch (...) {  // keep the ports opened before
    }
  }
  void poll(std::vector<LiveMessage>& out) {
    try {
      std::vector<unsigned char> bytes;
      for (const auto& port : ports_)
        for (int n = 0; n < most_packets; ++n) {
          port->getMessage(&bytes);
          if (bytes.empty()) break;
          if (auto m = read_midi(bytes)) out.push_back(*std::move(m));
        }
    } catch (...) {
      ports_.clear();
    }
  }

 private:
  // Silences RtMidi, whose warnings on standard error would spoil the picture.
  static std::unique_ptr<RtMidiIn> quiet() {
    auto in = std::make_unique<RtMidiIn>(RtMidi::UNSPECIFIED, "betwixt");
    in->setErrorCallback([](RtMidiError::Type, const std::string&, void*) {}, nullptr);
    return in;
  }
  std::vector<std::unique_ptr<RtMidiIn>> ports_;
};

// Returns the system's timestamp of a packet, or now if it has none.
std::chrono::steady_clock::time_point arrival(msghdr& packet) {
  using namespace std::chrono;
  const auto now = steady_clock::now();
  for (cmsghdr* c = CMSG_FIRSTHDR(&packet); c; c = CMSG_NXTHDR(&packet, c)) {
    if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_TIMESTAMPNS) continue;
    timespec stamp;
    std::memcpy(&stamp, CMSG_DATA(c), sizeof stamp);
    const auto ago = system_clock::now().time_since_epoch() - seconds(stamp.tv_sec) - nanoseconds(stamp.tv_nsec);
    return now - std::clamp(duration_cast<nanoseconds>(ago), nanoseconds(0), nanoseconds(10s));
  }
  return now;
}

class Live final : public LiveInput {
 public:
  explicit Live(int socket) : socket_(socket) {}
  ~Live() override { ::close(socket_); }
  Live(const Live&) = delete;
  Live& operator=(const Live&) = delete;

  std::vector<LiveMessage> poll() override {
    std::vector<LiveMessage> out;
    midi_.poll(out);
    for (int n = 0; n < most_packets; ++n) {
      iovec into{packet_.data(), packet_.size()};
      alignas(cmsghdr) std::array<char, 256> extra;
      msghdr asked{};
      asked.msg_iov = &into, asked.msg_iovlen = 1;
      asked.msg_control = extra.data(), asked.msg_controllen = extra.size();
      const ssize_t size = ::recvmsg(socket_, &asked, MSG_DONTWAIT);
      if (size < 0 && errno == EINTR) continue;
      if (size < 0) break;
      std::vector<LiveMessage> said = read_osc({packet_.data(), static_cast<std::size_t>(size)});
      if (said.empty()) ++ignored_;
      for (LiveMessage& m : said) m.arrived = arrival(asked);
      out.insert(out.end(), std::make_move_iterator(said.begin()), std::make_move_iterator(said.end()));
    }
    return out;
  }
  std::uint64_t ignored() const override { return ignored_; }

 private:
  const int socket_;
  Midi midi_;
  std::uint64_t ignored_ = 0;
  std::array<std::uint8_t, 65536> packet_;
};

}  // namespace

std::string in_words(const LiveMessage& m) {
  std::string out = m.address;
  for (const double d : m.numbers) out += fmt::format(" {:.4g}", d);
  return m.text ? out + " " + *m.text : out;
}

std::vector<LiveMessage> read_osc(std::span<const std::uint8_t> packet) {
  std::vector<LiveMessage> out;
  if (!read_element(packet, 0, out)) out.clear();
  return out;
}

std::optional<LiveMessage> read_midi(std::span<const std::uint8_t> m) {
  if (m.size() < 3 || m[1] > 127 || m[2] > 127) return std::nullopt;
  const int channel = (m[0] & 15) + 1;
  switch (m[0] & 0xF0) {
    case 0x80:
      return LiveMessage{fmt::format("/midi/note/{}/{}", channel, m[1]), {0}, {0.5 / 127}, {}};
    case 0x90:
      return LiveMessage{fmt::format("/midi/note/{}/{}", channel, m[1]), {m[2] / 127.0}, {0.5 / 127}, {}};
    case 0xB0:
      return LiveMessage{fmt::format("/midi/cc/{}/{}", channel, m[1]), {m[2] / 127.0}, {0.5 / 127}, {}};
    case 0xE0: {  // maps the middle, 8192, to 0, and reaches both ends
      const int bend = (m[1] | m[2] << 7) - 8192;
      return LiveMessage{
          fmt::format("/midi/bend/{}", channel), {bend / (bend < 0 ? 8192.0 : 8191.0)}, {0.5 / 8192}, {}};
    }
    default:
      return std::nullopt;
  }
}

Result<std::unique_ptr<LiveInput>> LiveInput::open(const std::string& where) {
  const std::size_t colon = where.rfind(':');
  std::string host = colon == std::string::npos ? "127.0.0.1" : where.substr(0, colon);
  const std::string port = colon == std::string::npos ? where : where.substr(colon + 1);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  int number = 0;
  const auto [end, wrong] = std::from_chars(port.data(), port.data() + port.size(), number);
  if (wrong != std::errc() || end != port.data() + port.size() || number < 1 || number > 65535 || host.empty())
    return fail(ErrorCode::range, fmt::format("--listen: \"{}\" is not a port", where),
                "as in 9000 or 192.168.1.5:9000");
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_socktype = SOCK_DGRAM;
  wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  if (::getaddrinfo(host.c_str(), port.c_str(), &wanted, &found) != 0)
    return fail(ErrorCode::range, fmt::format("--listen: there is no address {}", host));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, ::freeaddrinfo);
  const int s = ::socket(found->ai_family, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const int room = 1 << 20;  // for packets between two pictures; the system may give less
  if (s >= 0) ::setsockopt(s, SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
  const int stamped = 1;
  if (s >= 0) ::setsockopt(s, SOL_SOCKET, SO_TIMESTAMPNS, &stamped, sizeof stamped);
  if (s < 0 || ::bind(s, found->ai_addr, found->ai_addrlen) != 0) {
    const int error = errno;
    if (s >= 0) ::close(s);
    return fail(ErrorCode::file, fmt::format("--listen: cannot listen on {}: {}", where, std::strerror(error)),
                error == EADDRINUSE ? "another program uses this port; choose another one" : "");
  }
  return std::unique_ptr<LiveInput>(std::make_unique<Live>(s));
}

}  // namespace betwixt
