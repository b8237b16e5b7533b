// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Compiles the libraries that consist of headers.
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_GIF
#define STBI_NO_PIC
#define STBI_NO_PNM
#define STBI_NO_PSD
#define STBI_NO_STDIO
#include <stb_image.h>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

// Pictures stay encoded, so these functions do nothing; the library only needs their names.
namespace tinygltf {
bool LoadImageData(Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return false;
}
bool WriteImageData(const std::string*, const std::string*, const Image*, bool, std::string*, void*) { return false; }
}  // namespace tinygltf

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
