// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What rlottie draws of a file of Lottie: for each frame the middle of all that is opaque, in pixels. Compiled with
// PICTURES, the pictures: bytes of blue, green, red and opacity, premultiplied.
//   lottie FILE.json WIDTH HEIGHT FRAME…     lines: FRAME x y
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
#ifdef PICTURES
    fwrite(pixels, 4, width * height, stdout);
#else
    double sum = 0, x = 0, y = 0;
    for (size_t k = 0; k < width * height; ++k) {
      const double opaque = pixels[k] >> 24;
      sum += opaque, x += opaque * ((double)(k % width) + 0.5), y += opaque * ((double)(k / width) + 0.5);
    }
    printf("%s %.6f %.6f %.3f\n", words[i], sum > 0 ? x / sum : -1, sum > 0 ? y / sum : -1, sum / 255);
#endif
  }
  free(pixels);
  lottie_animation_destroy(film);
  return 0;
}
