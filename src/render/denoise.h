// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Takes the noise out of a picture of few samples: each pixel becomes a mean of pixels nearby that show the same light
// on the same surface. The light is divided by the albedo first, so textures stay. Two pixels are alike if their
// surroundings differ by no more than the noise explains (non-local means, with the variance of each pixel), and if
// normals and places say that they are on one surface. In the first pass each half of the samples is averaged with
// the weights that the other half suggests (Rousselle, Manzi, Zwicker: Robust Denoising using Feature and Color
// Information, 2013), so noise does not choose its own weights; the second pass averages the results of the first.
// Light that is far above that of all pixels nearby stays out of the means; if both halves show it, it is added at
// last.
#pragma once

#include "render/noisy_picture.h"

namespace betwixt::traced {

// Replaces `first` by the light without its noise. The other planes of light and variance have no meaning afterwards.
// The result does not depend on the number of threads, or the processor.
void denoise(NoisyPicture&, unsigned threads);

}  // namespace betwixt::traced
