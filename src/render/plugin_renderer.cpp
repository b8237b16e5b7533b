// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "render/plugin_renderer.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <map>

#include "base/stages.h"
#include "betwixt/plugin.h"
#include "commands/plugins.h"
#include "exchange/geometry.h"
#include "render/blur.h"
#include "render/columns.h"
#include "render/view.h"

namespace betwixt {
namespace {

constexpr std::size_t longest_message = 400;

// What both processes see at the beginning of their shared memory. The pointers in `frame` point into that memory,
// which has the same address in both.
struct Shared {
  betwixt_frame frame;
  unsigned char* picture;
  char why[longest_message];
};

// The columns of a frame for a plug-in, before they are copied to the shared memory.
struct Laid {
  std::vector<double> worlds, colors;
  std::vector<betwixt_mesh_range> ranges;
  std::vector<float> positions, normals;
  std::vector<unsigned> triangles;
  std::vector<betwixt_light> lights;

  // Returns where the bytes of each column begin, and in the last place their end.
  std::vector<std::size_t> layout(std::size_t picture_bytes) const {
    std::vector<std::size_t> at{sizeof(Shared)};
    const auto add = [&](std::size_t bytes) { at.push_back((at.back() + bytes + 63) / 64 * 64); };
    at[0] = (at[0] + 63) / 64 * 64;
    add(picture_bytes), add(bytes_of(worlds)), add(bytes_of(colors)), add(bytes_of(ranges)), add(bytes_of(positions));
    add(bytes_of(normals)), add(bytes_of(triangles)), add(bytes_of(lights));
    return at;
  }
  template <class T>
  static std::size_t bytes_of(const std::vector<T>& column) {
    return column.size() * sizeof(T);
  }
};

void put_row_by_row(const Mat4& m, double* out) {
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) out[4 * r + c] = m(r, c);
}

class PluginProcess {
 public:
  PluginProcess(PluginRenderer renderer, int patience) : renderer_(std::move(renderer)), patience_(patience) {}
  PluginProcess(const PluginProcess&) = delete;
  PluginProcess& operator=(const PluginProcess&) = delete;
  ~PluginProcess() { stop(), unmap(); }

  // Returns memory of at least so many bytes; a larger one is shared with a new process.
  Result<Shared*> memory(std::size_t bytes) {
    if (bytes <= size_) return shared_;
    stop(), unmap();
    const std::size_t wanted = bytes + bytes / 2;
    void* at = ::mmap(nullptr, wanted, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED) return fail(ErrorCode::machine, "there is not enough memory for this picture");
    size_ = wanted;
    shared_ = new (at) Shared{};
    return shared_;
  }

  // Lets the plug-in fill the picture.
  Status draw() {
    if (child_ < 0)
      if (Status begun = start(); !begun) return begun;
    const char go = 'g';
    char answer = 0;
    if (::send(channel_, &go, 1, MSG_NOSIGNAL) == 1) {
      pollfd waiting{channel_, POLLIN, 0};
      int ready = 0;
      do ready = ::poll(&waiting, 1, patience_);
      while (ready < 0 && errno == EINTR);
      if (ready == 0) return stop(), wrong(fmt::format("takes more than {} seconds for a picture", patience_ / 1000.0));
      while (::read(channel_, &answer, 1) < 0 && errno == EINTR) {
      }
    }
    if (answer == 'y') return Nothing{};
    if (answer != 'n') return stop(), wrong("has crashed");
    shared_->why[longest_message - 1] = '\0';
    return wrong(fmt::format("failed: {}", shared_->why));
  }

 private:
  Status wrong(const std::string& what) const {
    return fail(ErrorCode::machine, fmt::format("the renderer '{}' of {} {}", renderer_.name, renderer_.path, what));
  }

  Status start() {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      return wrong("cannot be started: there is no channel to its process");
    child_ = ::fork();
    if (child_ == 0) serve(ends[1]);
    ::close(ends[1]);
    channel_ = ends[0];
    if (child_ < 0) return stop(), wrong("cannot be started: there is no process");
    return Nothing{};
  }

  // The plug-in's process: fills a picture for each byte that it reads.
  [[noreturn]] void serve(int channel) const {
    for (const int s : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGTERM, SIGINT, SIGPIPE, SIGALRM})
      std::signal(s, SIG_DFL);
    const int last = static_cast<int>(std::min<long>(::sysconf(_SC_OPEN_MAX), 4096));
    for (int fd = 3; fd < last; ++fd)
      if (fd != channel) ::close(fd);
    for (char go = 0; ::read(channel, &go, 1) == 1;) {
      ::alarm(static_cast<unsigned>(patience_ / 1000 + 5));  // in case the program is gone by then
      const char* why = nullptr;
      char answer = 'n';
      try {
        answer = renderer_.function(&shared_->frame, shared_->picture, &why, renderer_.user) == 0 ? 'y' : 'n';
      } catch (...) {
        why = "it threw an exception";
      }
      std::strncpy(shared_->why, why ? why : "it gave no reason", longest_message - 1);
      ::alarm(0);
      if (::write(channel, &answer, 1) != 1) break;
    }
    ::_exit(0);
  }

  void stop() {
    if (channel_ >= 0) ::close(channel_);
    channel_ = -1;
    if (child_ <= 0) return void(child_ = -1);
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
  }
  void unmap() {
    if (size_ > 0) ::munmap(shared_, size_);
    size_ = 0;
  }

  PluginRenderer renderer_;
  int patience_;  // ms
  pid_t child_ = -1;
  int channel_ = -1;
  Shared* shared_ = nullptr;
  std::size_t size_ = 0;
};

class RendererOfPlugin final : public Renderer {
 public:
  RendererOfPlugin(const RenderOptions& options, PluginRenderer renderer, int patience)
      : width_(options.width),
        height_(options.height),
        linear_(options.linear),
        process_(std::move(renderer), patience) {}

  Status render(const Frame& frame, Picture& out) override {
    const FrameColumns laid_out(frame);
    return draw(laid_out.columns(), out);
  }
  Status render(const Evaluation& evaluation, Picture& out) override { return draw(columns_of(evaluation), out); }
  Status render(const Frame& frame, LinearPicture& out) override {
    const FrameColumns laid_out(frame);
    return give(laid_out.columns(), out);
  }
  Status render(const Evaluation& evaluation, LinearPicture& out) override { return give(columns_of(evaluation), out); }
  Status render_blurred(Evaluation& evaluation, Time t, const Blur& how, LinearPicture& out) override {
    const auto draw_part = [&](const Columns& columns, LinearPicture& one) { return give(columns, one); };
    return betwixt::render_blurred(evaluation, t, how, width_, height_, draw_part, out);
  }

 private:
  Status give(const Columns& columns, LinearPicture& out) {
    if (!linear_) return fail(ErrorCode::range, "pictures of linear light need a renderer with that option");
    Picture shown;
    if (Status drawn = draw(columns, shown); !drawn) return drawn;
    out.width = width_, out.height = height_;
    out.rgba.resize(shown.rgba.size());
    for (std::size_t i = 0; i < shown.rgba.size(); ++i) {
      const double byte = shown.rgba[i] / 255.0;
      const bool opacity = i % 4 == 3;
      out.rgba[i] = static_cast<float>(opacity           ? byte
                                       : byte <= 0.04045 ? byte / 12.92
                                                         : std::pow((byte + 0.055) / 1.055, 2.4));
    }
    return Nothing{};
  }

  Status draw(const Columns& columns, Picture& out) {
    const InStage drawing(Stage::draw);
    bool good = false, always = true;
    View view = make_view(columns.camera, width_, height_, good);
    if (!good) view = make_view({}, width_, height_, always);
    const Laid laid = lay_out(columns, view, good);
    const std::size_t bytes = 4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
    const std::vector<std::size_t> at = laid.layout(bytes);
    const auto memory = process_.memory(at.back());
    if (!memory) return memory.error();
    Shared& shared = **memory;
    char* const begin = reinterpret_cast<char*>(&shared);
    shared.picture = reinterpret_cast<unsigned char*>(begin + at[0]);
    std::memset(shared.picture, 0, bytes);
    std::size_t column = 1;
    const auto put = [&]<class T>(const std::vector<T>& from) {
      T* const to = reinterpret_cast<T*>(begin + at[column++]);
      if (!from.empty()) std::memcpy(to, from.data(), Laid::bytes_of(from));
      return static_cast<const T*>(to);
    };
    betwixt_frame& f = shared.frame;
    f = {};
    f.width = width_, f.height = height_, f.count = laid.ranges.size(), f.light_count = laid.lights.size();
    f.world = put(laid.worlds), f.color = put(laid.colors), f.mesh = put(laid.ranges);
    f.position = put(laid.positions), f.normal = put(laid.normals), f.triangle = put(laid.triangles);
    f.light = put(laid.lights);
    put_row_by_row(columns.camera.world, f.camera);
    f.orthographic = view.orthographic ? 1 : 0;
    f.scale[0] = view.sx, f.scale[1] = view.sy;
    const Vec3 back = columns.background.value_or(Vec3{});
    f.background[0] = back.x, f.background[1] = back.y, f.background[2] = back.z;
    if (Status drawn = process_.draw(); !drawn) return drawn;
    out.width = width_, out.height = height_;
    out.rgba.assign(shared.picture, shared.picture + bytes);
    return Nothing{};
  }

  // Lays out the visible objects. Objects with the same mesh share its vertices.
  Laid lay_out(const Columns& columns, const View& view, bool good) {
    Laid laid;
    std::map<const Mesh*, betwixt_mesh_range> known;
    std::vector<Geometry> held;
    for (std::uint32_t i = 0; good && i < columns.looks.size(); ++i) {
      const Evaluation::Look& l = columns.looks[i];
      if (!l.visible || l.shape == Evaluation::Look::none || l.transparency >= 1 || !finite(columns.worlds[i]))
        continue;
      const Shape& shape = *columns.shape(l.shape);
      const bool turns = l.toward != Evaluation::Look::none && l.blend != 0;
      const Detail detail = Detail::for_pixels(view.height / 4.0);
      held.push_back(turns ? realise_blend(shape, *columns.shape(l.toward), l.blend, detail) : realise(shape, detail));
      const Geometry& g = held.back();
      if (g.mesh->triangles.empty()) continue;
      const auto [mesh, fresh] = known.try_emplace(g.mesh.get());
      if (fresh) mesh->second = add_mesh(laid, *g.mesh);
      laid.ranges.push_back(mesh->second);
      laid.worlds.resize(laid.worlds.size() + 16);
      put_row_by_row(columns.worlds[i] * g.local, &laid.worlds[laid.worlds.size() - 16]);
      for (const double c : {l.color.x, l.color.y, l.color.z, 1 - l.transparency}) laid.colors.push_back(c);
    }
    for (const Light& light : columns.lights)
      laid.lights.push_back({light.sun ? 1 : 0,
                             {light.position.x, light.position.y, light.position.z},
                             {light.direction.x, light.direction.y, light.direction.z},
                             {light.color.x, light.color.y, light.color.z},
                             light.range});
    held_ = std::move(held);  // so that meshes are made once
    return laid;
  }

  static betwixt_mesh_range add_mesh(Laid& laid, const Mesh& mesh) {
    const betwixt_mesh_range range{laid.positions.size() / 3, mesh.positions.size(), laid.triangles.size() / 3,
                                   mesh.triangles.size() / 3};
    for (const auto& p : mesh.positions) laid.positions.insert(laid.positions.end(), p.begin(), p.end());
    for (const auto& n : mesh.normals) laid.normals.insert(laid.normals.end(), n.begin(), n.end());
    laid.normals.resize(laid.positions.size());
    laid.triangles.insert(laid.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    return range;
  }

  const int width_, height_;
  const bool linear_;
  PluginProcess process_;
  std::vector<Geometry> held_;
};

}  // namespace

Result<std::unique_ptr<Renderer>> make_plugin_renderer(const RenderOptions& options, int patience) {
  auto renderer = plugin_renderer(options.style);
  if (!renderer)
    return fail(ErrorCode::name, fmt::format("no plug-in has a renderer '{}'", options.style.substr(0, 64)));
  return std::unique_ptr<Renderer>(std::make_unique<RendererOfPlugin>(options, *std::move(renderer), patience));
}

}  // namespace betwixt
