// The projected vertices that the oracle pictures of ../shared/assets/oracle were drawn from.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "golden/triangle/draw.h"

namespace wrinkle {

// "WRTS", the number of triangles, then 14 floats a corner: x, y in pixels, z, w, u, v, L, H in tangent space, two
// unused.
inline std::vector<ScreenTriangle> read_stored_vertices(const std::string& path, int subpixel_bits) {
  const auto close = [](FILE* f) { return pclose(f); };
  const std::unique_ptr<FILE, decltype(close)> pipe(popen(("xzcat '" + path + "'").c_str(), "r"), close);
  std::array<char, 4> magic{};
  std::uint32_t count = 0;
  if (!pipe || fread(magic.data(), 4, 1, pipe.get()) != 1 || std::memcmp(magic.data(), "WRTS", 4) != 0 ||
      fread(&count, 4, 1, pipe.get()) != 1) {
    throw std::runtime_error(path + " is not a file of stored vertices");
  }
  const double grid = 1 << subpixel_bits;
  std::vector<ScreenTriangle> triangles(count);
  for (std::uint32_t id = 0; id < count; ++id) {
    triangles[id].id = id;
    for (ScreenVertex& v : triangles[id].v) {
      std::array<float, 14> f;
      if (fread(f.data(), sizeof f, 1, pipe.get()) != 1) throw std::runtime_error(path + " is truncated");
      v.x = static_cast<std::int32_t>(std::lround(static_cast<double>(f[0]) * grid));
      v.y = static_cast<std::int32_t>(std::lround(static_cast<double>(f[1]) * grid));
      v.z = 0.5 + 0.5 * static_cast<double>(f[2]);
      v.q = 1 / static_cast<double>(f[3]);
      v.uv = {f[4], f[5]};
      v.L = normalize(Vec3{f[6], f[7], f[8]});
      v.H = normalize(Vec3{f[9], f[10], f[11]});
      v.N = {0, 0, 1};
    }
  }
  return triangles;
}

}  // namespace wrinkle
