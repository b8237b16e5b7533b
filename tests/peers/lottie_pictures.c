// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of a file of Lottie as rlottie draws them: bytes of blue, green, red and opacity, premultiplied.
//   lottie_pictures FILE.json WIDTH HEIGHT FRAME… >PIXELS
#include <rlottie_capi.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int count, char** words) {
  if (count < 5) return 2;
  Lottie_Animation* film = lottie_animation_from_file(words[1]);
  if (!film) return 1;
  const size_t width = (size_t)atoi(words[2]), height = (size_t)atoi(words[3]);
  uint32_t* pixels = malloc(4 * width * height);
  for (int i = 4; i < count; ++i) {
    memset(pixels, 0, 4 * width * height);
    lottie_animation_render(film, (size_t)atoi(words[i]), pixels, width, height, 4 * width);
    fwrite(pixels, 4, width * height, stdout);
  }
  free(pixels);
  lottie_animation_destroy(film);
  return 0;
}
