// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes the reader of glTF scenes, and the reader of the data that our parser process hands over, with any bytes. The
// input is refused, or the result is valid. A valid result is handed over unchanged.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

#include "base/files.h"
#include "exchange/scene_file.h"
#include "exchange/wire_format.h"
#include "fuzz.h"

using namespace betwixt;

namespace {

class OneFile final : public FileSource {
 public:
  explicit OneFile(std::string_view bytes) : bytes_(bytes) {}
  bool has(const std::string&) override { return false; }
  Result<std::string> read(const std::string& path) override {
    return path == "it.glb" ? Result<std::string>(std::string(bytes_)) : fail(ErrorCode::file, "nothing else is there");
  }

 private:
  std::string_view bytes_;
};

void hand_on(const std::shared_ptr<const SceneFile>& scene) {
  insist(sound(*scene), "a scene that is read is sound");
  const OpenFile memory(::memfd_create("fuzz", MFD_CLOEXEC));
  insist(write_parsed(scene, memory.fd()) == 0, "a scene can be handed over");
  Parsed got;
  insist(read_parsed(memory.fd(), got) == 0, "a scene that is sound is taken over");
  insist(std::holds_alternative<std::shared_ptr<const SceneFile>>(got), "a scene is a scene");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Slow slow;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (bytes.starts_with("glTF") || bytes.starts_with("{")) {
    OneFile files(bytes);
    const auto scene = load_gltf_scene("it.glb", files);
    if (scene)
      hand_on(*scene);
    else
      insist(!scene.error().message.empty(), "an error has words");
    return slow.verdict();
  }
  const OpenFile memory(::memfd_create("fuzz", MFD_CLOEXEC));
  insist(write_all(memory.fd(), bytes) == 0, "memory can be written");
  Parsed got;
  if (read_parsed(memory.fd(), got) == 0)
    if (const auto* scene = std::get_if<std::shared_ptr<const SceneFile>>(&got)) hand_on(*scene);
  return slow.verdict();
}
