// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/listener.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/random.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>

namespace betwixt {
namespace {

constexpr int backlog = 512;

class File {
 public:
  explicit File(int file) : file_(file) {}
  ~File() {
    if (file_ >= 0) ::close(file_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int get() const { return file_; }
  int release() { return std::exchange(file_, -1); }

 private:
  int file_;
};

Error system_said(ErrorCode code, const std::string& what, int why) {
  return fail(code, fmt::format("{}: {}", what, std::strerror(why)));
}

// Removes the socket that a killed server has left behind. Returns an error if a server still listens there, or if the
// file is no socket.
Status make_room(const std::string& path, const sockaddr_un& address) {
  struct stat there {};
  if (::lstat(path.c_str(), &there) != 0) return Nothing{};
  if (!S_ISSOCK(there.st_mode))
    return fail(ErrorCode::file, fmt::format("'{}' already exists and is not a socket", path));
  const File probe(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int answer = ::connect(probe.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  if (answer == 0 || errno == EAGAIN || errno == EINPROGRESS)
    return fail(ErrorCode::file, fmt::format("another server uses '{}'", path), "choose another path: --socket PATH");
  if (errno != ECONNREFUSED) return system_said(ErrorCode::file, fmt::format("'{}' cannot be used", path), errno);
  if (::unlink(path.c_str()) != 0)
    return system_said(ErrorCode::file, fmt::format("the socket '{}' cannot be removed", path), errno);
  return Nothing{};
}

bool loopback(const sockaddr* a) {
  if (a->sa_family == AF_INET) return (ntohl(reinterpret_cast<const sockaddr_in*>(a)->sin_addr.s_addr) >> 24) == 127;
  return a->sa_family == AF_INET6 && IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6*>(a)->sin6_addr);
}

std::string address_name(int file) {
  sockaddr_storage a{};
  socklen_t size = sizeof a;
  std::array<char, NI_MAXHOST> host{};
  std::array<char, NI_MAXSERV> port{};
  if (::getsockname(file, reinterpret_cast<sockaddr*>(&a), &size) != 0 ||
      ::getnameinfo(reinterpret_cast<sockaddr*>(&a), size, host.data(), host.size(), port.data(), port.size(),
                    NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return "";
  return a.ss_family == AF_INET6 ? fmt::format("[{}]:{}", host.data(), port.data())
                                 : fmt::format("{}:{}", host.data(), port.data());
}

// Returns false if the path is too long.
bool name_socket(sockaddr_un& address, const std::string& path) {
  if (path.size() >= sizeof address.sun_path) return false;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
  return true;
}

// Returns 0 or the errno. The socket listens before it has its name: whoever sees the file can connect. If there is no
// room for the longer hidden name, it has its name a moment earlier.
int listen_at(int file, const std::string& path, sockaddr_un address) {
  const std::string hidden = fmt::format("{}.{}", path, ::getpid());
  const bool moves = name_socket(address, hidden);
  if (moves) ::unlink(hidden.c_str());
  const mode_t before = ::umask(0177);  // so that the socket never exists with wider permissions
  int why = ::bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0 : errno;
  ::umask(before);
  if (why == 0 && ::listen(file, backlog) != 0) why = errno;
  if (!moves) return why;
  if (why == 0 && ::link(hidden.c_str(), path.c_str()) != 0) why = errno;  // fails if another server was faster
  ::unlink(hidden.c_str());
  return why;
}

}  // namespace

Result<Listener> Listener::unix_socket(const std::string& path) {
  sockaddr_un address{};
  if (path.empty() || !name_socket(address, path))
    return fail(ErrorCode::range, fmt::format("--socket: a path must have 1 to {} bytes", sizeof address.sun_path - 1));
  if (Status s = make_room(path, address); !s) return s.error();
  File file(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (file.get() < 0) return system_said(ErrorCode::machine, "cannot make a socket", errno);
  if (const int why = listen_at(file.get(), path, address); why != 0)
    return system_said(ErrorCode::file, fmt::format("cannot listen at '{}'", path), why);
  Listener out(file.release(), path, false);
  struct stat mine {};
  if (::lstat(path.c_str(), &mine) == 0) out.device_ = mine.st_dev, out.inode_ = mine.st_ino;
  return out;
}

Result<Listener> Listener::tcp(const std::string& where, bool anywhere) {
  const std::size_t colon = where.rfind(':');
  std::string host = colon == std::string::npos ? "" : where.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  if (host.empty() || colon + 1 == where.size())
    return fail(ErrorCode::range, fmt::format("--tcp: \"{}\" is not an address", where), "as in 127.0.0.1:9100");
  unsigned port = 0;
  const auto [end, wrong] = std::from_chars(where.data() + colon + 1, where.data() + where.size(), port);
  if (wrong != std::errc() || end != where.data() + where.size() || port > 65535)
    return fail(ErrorCode::range, fmt::format("--tcp: '{}' is not a port", where.substr(colon + 1, 60)),
                "write a number from 0 (any free port) to 65535");
  addrinfo wanted{}, *found = nullptr;
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
  if (::getaddrinfo(host.c_str(), where.c_str() + colon + 1, &wanted, &found) != 0)
    return fail(ErrorCode::range, fmt::format("--tcp: there is no address {}", where));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, ::freeaddrinfo);
  if (!loopback(found->ai_addr) && !anywhere)
    return fail(ErrorCode::range, fmt::format("--tcp: other machines can reach {}", where),
                "to allow that: --anywhere; the connection is not encrypted");
  File file(::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int on = 1;
  if (file.get() >= 0) ::setsockopt(file.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  if (file.get() < 0 || ::bind(file.get(), found->ai_addr, found->ai_addrlen) != 0 ||
      ::listen(file.get(), backlog) != 0)
    return system_said(ErrorCode::file, fmt::format("--tcp: cannot listen at {}", where), errno);
  const std::string name = address_name(file.get());
  return Listener(file.release(), name, true);
}

Listener::Listener(Listener&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      name_(std::move(other.name_)),
      asks_(other.asks_),
      device_(other.device_),
      inode_(other.inode_) {}

Listener::~Listener() {
  if (file_ < 0) return;
  ::close(file_);
  struct stat there {};
  if (!asks_ && ::lstat(name_.c_str(), &there) == 0 && there.st_dev == device_ && there.st_ino == inode_)
    ::unlink(name_.c_str());
}

int Listener::accept() const {
  const int file = ::accept4(file_, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
  const int on = 1;
  if (file >= 0 && asks_) ::setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return file;
}

std::string default_socket() {
  const char* folder = std::getenv("XDG_RUNTIME_DIR");
  return folder && *folder ? fmt::format("{}/betwixt.sock", folder) : "";
}

Result<std::string> new_token() {
  std::array<unsigned char, 16> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return system_said(ErrorCode::machine, "cannot make a token", errno);
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

bool same_token(std::string_view said, std::string_view token) {
  unsigned differs = said.size() != token.size();
  for (std::size_t i = 0; i < token.size(); ++i)
    differs |= static_cast<unsigned char>(i < said.size() ? said[i] : 0) ^ static_cast<unsigned char>(token[i]);
  return differs == 0;
}

}  // namespace betwixt
