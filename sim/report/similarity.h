// How alike two pictures are, beyond PSNR.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/picture.h"

namespace wrinkle {

// SSIM of the luminance, mean over the pixels of `mask`: windows of 11 by 11, Gaussian of 1.5 pixels, K1 = .01,
// K2 = .03, peak 1 [Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment, IEEE Trans. Image Processing, 2004].
// 1 for equal pictures.
double structural_similarity(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask);

// The error that a share `1 - rank` of the compared channels exceeds; rank in [0, 1].
double error_percentile(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask, double rank);

}  // namespace wrinkle
