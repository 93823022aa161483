// The perturbed normal, in every form that the papers give: one place for the formulas.
//
// Pu, Pv are the partial derivatives of the surface, fu, fv those of the height field along the unit normal, all with
// respect to the same u, v. Results are unit vectors; where everything vanishes, zero.
#pragma once

#include <cmath>

#include "golden/vector.h"

namespace wrinkle {

// N' in the space of Pu and Pv [Peercy97 eq. 1-2, after Blinn78].
inline Vec3 perturbed_normal_blinn(Vec3 Pu, Vec3 Pv, double fu, double fv) {
  const Vec3 area = cross(Pu, Pv);
  const Vec3 N = normalize(area);
  const Vec3 D = -fu * cross(Pv, N) - fv * cross(N, Pu);
  return normalize(area + D);
}

// N' in tangent space: T = Pu / |Pu|, B = N x T, N [Peercy97 eq. 3-6].
inline Vec3 tangent_space_normal(Vec3 Pu, Vec3 Pv, double fu, double fv) {
  const Vec3 area = cross(Pu, Pv);
  const Vec3 T = normalize(Pu);
  const Vec3 B = cross(normalize(area), T);
  const double a = -fu * dot(B, Pv);
  const double b = -(fv * length(Pu) - fu * dot(T, Pv));
  const double c = length(area);
  return normalize(Vec3{a, b, c});
}

// N' in tangent space where the parameterization is taken for a square patch, |Pu| = |Pv| = k [Peercy97 eq. 8-11].
inline Vec3 square_patch_normal(double k, double fu, double fv) { return normalize(Vec3{-k * fu, -k * fv, k * k}); }

// N' by the surface gradient, for a unit normal n of either orientation [Mikkelsen10 eq. 3-4]. (sigma_s, sigma_t) is
// any parameterization; it must not be degenerate.
inline Vec3 perturbed_normal_mikkelsen(Vec3 n, Vec3 sigma_s, Vec3 sigma_t, double beta_s, double beta_t) {
  const double determinant = dot(n, cross(sigma_s, sigma_t));
  const Vec3 gradient = (1 / determinant) * (beta_s * cross(sigma_t, n) + beta_t * cross(n, sigma_s));
  return normalize(n - gradient);
}

}  // namespace wrinkle
