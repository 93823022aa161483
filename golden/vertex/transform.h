// Affine maps of points, directions and normals, and the matrices that scenes are placed by.
#pragma once

#include "golden/vector.h"

namespace wrinkle {

Mat4 operator*(const Mat4& a, const Mat4& b);
Mat4 translation(Vec3 by);
Mat4 scaling(Vec3 by);
// By `angle` radians about the axis through the origin, counter-clockwise seen from its tip.
Mat4 rotation(Vec3 axis, double angle);
// Of an affine matrix (last row 0 0 0 1) with an invertible linear part.
Mat4 affine_inverse(const Mat4& m);
double determinant3(const Mat4& m);
bool is_identity(const Mat4& m);

Vec3 transform_point(const Mat4& m, Vec3 p);
Vec3 transform_direction(const Mat4& m, Vec3 d);
// By the inverse transpose of the linear part, up to a positive factor: outward normals stay outward, whatever the sign
// of the determinant.
Vec3 transform_normal(const Mat4& m, Vec3 n);

}  // namespace wrinkle
