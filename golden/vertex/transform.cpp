#include "golden/vertex/transform.h"

namespace wrinkle {
namespace {

Vec3 column(const Mat4& m, int j) { return {m(0, j), m(1, j), m(2, j)}; }

}  // namespace

Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 product;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      product(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j) + a(i, 3) * b(3, j);
    }
  }
  return product;
}

Mat4 translation(Vec3 by) {
  Mat4 m;
  m(0, 3) = by.x, m(1, 3) = by.y, m(2, 3) = by.z;
  return m;
}

Mat4 scaling(Vec3 by) {
  Mat4 m;
  m(0, 0) = by.x, m(1, 1) = by.y, m(2, 2) = by.z;
  return m;
}

// Rodrigues: R = c I + s [a]x + (1 - c) a a^T.
Mat4 rotation(Vec3 axis, double angle) {
  const Vec3 a = normalize(axis);
  const double c = std::cos(angle), s = std::sin(angle), d = 1 - c;
  Mat4 m;
  m(0, 0) = c + d * a.x * a.x, m(0, 1) = d * a.x * a.y - s * a.z, m(0, 2) = d * a.x * a.z + s * a.y;
  m(1, 0) = d * a.x * a.y + s * a.z, m(1, 1) = c + d * a.y * a.y, m(1, 2) = d * a.y * a.z - s * a.x;
  m(2, 0) = d * a.x * a.z - s * a.y, m(2, 1) = d * a.y * a.z + s * a.x, m(2, 2) = c + d * a.z * a.z;
  return m;
}

double determinant3(const Mat4& m) { return dot(column(m, 0), cross(column(m, 1), column(m, 2))); }

Mat4 affine_inverse(const Mat4& m) {
  const Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2);
  const double scale = 1 / determinant3(m);
  const Vec3 rows[3] = {scale * cross(y, z), scale * cross(z, x), scale * cross(x, y)};
  Mat4 inverse;
  for (int i = 0; i < 3; ++i) {
    inverse(i, 0) = rows[i].x, inverse(i, 1) = rows[i].y, inverse(i, 2) = rows[i].z;
    inverse(i, 3) = -dot(rows[i], column(m, 3));
  }
  return inverse;
}

bool is_identity(const Mat4& m) { return m.m == Mat4{}.m; }

Vec3 transform_point(const Mat4& m, Vec3 p) { return transform_direction(m, p) + column(m, 3); }

Vec3 transform_direction(const Mat4& m, Vec3 d) { return d.x * column(m, 0) + d.y * column(m, 1) + d.z * column(m, 2); }

Vec3 transform_normal(const Mat4& m, Vec3 n) {
  const Vec3 x = column(m, 0), y = column(m, 1), z = column(m, 2);
  const double side = determinant3(m) < 0 ? -1 : 1;
  return side * (n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y));
}

}  // namespace wrinkle
