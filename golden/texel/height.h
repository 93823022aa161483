// Height fields: f(u, v) in units of length, and its derivatives.
//
// Sample (x, y) lies at u = (x + 1/2) / width, v = 1 - (y + 1/2) / height: v goes up, as everywhere on surfaces, while
// rows go down. Beyond its border the field goes on as the texture does.
#pragma once

#include <memory>

#include "golden/texel/grid.h"
#include "golden/triangle/draw.h"
#include "golden/vector.h"

namespace wrinkle {

// (f_u, f_v) at every sample, per unit of u and v, by the derivative of a Gaussian (sigma one sample) covering seven by
// seven samples [Peercy97 section 3]. Exact for quadratic fields.
Grid<Vec2> gradients(const Grid<double>& height, Wraps wraps = {});

// The field between its samples, for the ideal picture: the derivatives above, interpolated bilinearly.
class SampledHeightField : public HeightField {
 public:
  explicit SampledHeightField(const Grid<double>& height, Wraps wraps = {})
      : gradients_(gradients(height, wraps)), wraps_(wraps) {}
  Vec2 gradient(double u, double v) const override;

 private:
  Grid<Vec2> gradients_;
  Wraps wraps_;
};

// The pinwheel of [Peercy97 fig. 4] by its description: twelve twisted vanes within a disc, each other one raised by
// `amplitude`, with upright sides that are antialiased over one sample. Size x size samples; it repeats without a seam.
Grid<double> pinwheel(int size = 512, double amplitude = 0.02);

}  // namespace wrinkle
