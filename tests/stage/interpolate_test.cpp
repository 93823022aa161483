// interpolate: exact modulo 2^width, in every lane; and, after set-up, within its bound of the exact planes.
#include <cmath>

#include "tests/stage/walk.h"

namespace wrinkle {
namespace {

__extension__ using Int128 = __int128;

// A packet of random planes over a random parallelogram: whatever the bits, the value is the contract's formula.
TriangleWords random_packet(const Config& config, Random& random) {
  TriangleWords t(config);
  t.y = static_cast<int>(uniform(random, 0, 3));
  t.rows = t.rows_end0 = static_cast<int>(uniform(random, 1, 10));
  const std::int64_t start = uniform(random, 0, 2), length = uniform(random, 1, 14);
  const std::int64_t denominator = uniform(random, 1, 50), carry = uniform(random, 0, denominator - 1);
  const std::int64_t remainder = uniform(random, -denominator, -1);
  t.start = {start, 0, remainder, carry, denominator};
  t.end0 = {start + length, 0, remainder, carry, denominator};
  for (std::size_t p = 0; const PlaneFormat& format : plane_formats(config)) {
    const std::int64_t limit = std::int64_t{1} << (format.width + config.guard_bits - 1);
    PlaneWords& plane = t.planes[p++];
    if (format.is_held) {
      plane.value = pattern(random, {-limit >> config.guard_bits, (limit >> config.guard_bits) - 1});
      continue;
    }
    plane = {pattern(random, {-limit, limit - 1}), pattern(random, {-limit, limit - 1}),
             pattern(random, {-limit, limit - 1})};
  }
  if (Shape(config).textured != 0 && config.perspective == 0)
    t.lod = static_cast<int>(uniform(random, 0, (16 << Shape(config).lod_fraction_bits) - 1));
  return t;
}

// The value of a plane at a pixel by the formula, in wide integers, w the walk coordinate.
std::int64_t expected(const Config& config, const PlaneFormat& format, const PlaneWords& plane, const TriangleWords& t,
                      std::int64_t w, std::int64_t y) {
  if (format.is_held) return plane.value;
  EdgeWords edge = t.start;  // the start of the row, and the carries on the way
  Int128 value = plane.value;
  for (std::int64_t row = t.y; row < y; ++row) {
    edge.remainder += edge.remainder_step;
    const bool carry = edge.remainder >= 0;
    if (carry) edge.remainder -= edge.denominator;
    edge.w += edge.step + carry;
    value += Int128{plane.row} + (carry ? plane.dw : 0);
  }
  value += Int128{plane.dw} * (w - edge.w);
  const int bits = format.width + config.guard_bits;
  const auto wrapped = static_cast<std::uint64_t>(value) << (64 - bits);
  const int down = 64 - format.width;
  return format.is_signed ? static_cast<std::int64_t>(wrapped) >> down : static_cast<std::int64_t>(wrapped >> down);
}

std::int64_t got(const FragmentValues& values_of, const std::vector<Value>& list, std::string_view name,
                 std::size_t element) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].stage == "interpolate" && list[i].name == name) return values_of[i][element];
  throw std::logic_error("interpolate hands on no such value");
}

TEST(Interpolate, IsTheFormulaModuloTheWidth) {
  Random random(base_seed());
  for (const auto& [name, config] : configurations(30)) {
    SCOPED_TRACE(name);
    const auto list = values(config);
    const auto formats = plane_formats(config);
    Context context = make_context(config);
    for (int round = 0; round < 12; ++round) {
      const TriangleWords t = random_packet(config, random);
      std::vector<std::uint64_t> words;
      encode(config, DrawWords{}, words);
      encode(config, t, words);
      for (Lanes lanes : {Lanes::kSimd, Lanes::kChecked}) {
        int count = 0;
        const auto sink = [&](const auto& batch) {
          FragmentValues all;
          for (int i = 0; i < batch.count; ++i, ++count) {
            extract(batch, i, all);
            const auto x = batch.scan_x[0][static_cast<std::size_t>(i)],
                       y = batch.scan_y[0][static_cast<std::size_t>(i)];
            for (std::size_t p = 0; p < formats.size(); ++p)
              ASSERT_EQ(got(all, list, formats[p].name, formats[p].element),
                        expected(config, formats[p], t.planes[p], t, x, y))
                  << formats[p].name << '[' << formats[p].element << "] at " << x << ' ' << y;
            if (Shape(config).textured != 0 && config.perspective == 0) {
              ASSERT_EQ(got(all, list, "lod", 0), t.lod);
            }
          }
        };
        Golden(config, {}, lanes).draw(words, {sink, sink});
        ASSERT_EQ(count, t.rows * static_cast<int>(t.end0.w - t.start.w));
      }
    }
  }
}

TEST(Interpolate, AllTargetsAgree) {
  Random random(base_seed());
  for (const auto& [name, config] : configurations(6)) {
    std::vector<std::uint64_t> words;
    encode(config, DrawWords{}, words);
    for (int i = 0; i < 40; ++i) encode(config, random_packet(config, random), words);
    const auto draw = [&](Lanes lanes) {
      std::vector<FragmentValues> all;
      const auto sink = [&](const auto& batch) {
        for (int i = 0; i < batch.count; ++i) extract(batch, i, all.emplace_back());
      };
      Golden(config, {}, lanes).draw(words, {sink, sink});
      return all;
    };
    const auto scalar = draw(Lanes::kScalar);
    for_each_target(
        [&](const std::string& target) { ASSERT_EQ(draw(Lanes::kSimd), scalar) << name << ", " << target; });
  }
}

// The wide planes of blinn keep the same bound; what is constant is rounded once.
TEST(Interpolate, CrossProductsStayWithinTheirBound) {
  Worst planes("interpolate a, b, c, share of 1/2 + (steps + 2) 2^-(G+1)", 1);
  Worst constants("interpolate b, c held over a triangle, LSB", 0.5);
  Random random(base_seed());
  const int size = 100;
  for (int cross : {0, 1}) {
    for (int block : {0, 1}) {
      const Config config =
          with({{&Config::datapath, 2}, {&Config::cross_products, cross}, {&Config::block_exponent, block}});
      DrawState state;
      state.bump = state.textured = true;
      Texture texture;
      texture.levels = {{0}};
      const std::vector<Texture> textures{texture};
      const DrawWords draw = quantise(config, state, textures);
      for (int round = 0; round < 50; ++round) {
        const ScreenTriangle triangle = random_triangle(config, random, size);
        const Corners corners = sort_corners(config, triangle);
        if (corners.area == 0) continue;
        const exact::Barycentric barycentric(config, corners);
        const exact::Attributes attributes(config, corners, draw);
        const auto sink = [&](const auto& batch) {
          for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
            const auto x = static_cast<int>(batch.scan_x[0][i]), y = static_cast<int>(batch.scan_y[0][i]);
            const exact::Interpolated want = attributes.at(barycentric.at(x, y));
            const double bound = 0.5 + (2 * size + 2) * std::ldexp(1.0, -config.guard_bits - 1);
            const auto error = [&](std::int64_t value, double exact) {
              return static_cast<double>(value) - std::ldexp(exact, config.wide_bits);
            };
            planes.see(error(batch.interpolate_frame[0][i], want.frame[0].x) / bound);
            planes.see(error(batch.interpolate_frame[2][i], want.frame[0].z) / bound);
            const double b = error(batch.interpolate_frame[4][i], want.frame[1].y),
                         c = error(batch.interpolate_frame[8][i], want.frame[2].z);
            if (cross == 0)
              planes.see(b / bound), planes.see(c / bound);
            else
              constants.see(b), constants.see(c);
          }
        };
        Golden(config, textures).draw(packets_of(config, triangle, state, textures, size), {sink, sink});
      }
    }
  }
}

// Half an LSB of the output; half a guard LSB for the corners, for the value and for every pixel and row stepped.
TEST(Interpolate, StaysWithinItsBoundOfThePlanes) {
  Worst worst("interpolate, share of 1/2 + (steps + 2) 2^-(G+1)", 1);
  Worst lsb("interpolate at G = 10, 200 x 200 pixels, LSB", 0.5 + 402 * std::ldexp(1.0, -11));
  Random random(base_seed());
  const int size = 200;
  for (int guard : {4, 10}) {
    const Config config = with({{&Config::guard_bits, guard}});
    for (int round = 0; round < 200; ++round) {
      const ScreenTriangle triangle = random_triangle(config, random, size);
      const Corners corners = sort_corners(config, triangle);
      if (corners.area == 0) continue;
      const exact::Barycentric barycentric(config, corners);
      const exact::Attributes attributes(config, corners, DrawWords{});
      const auto sink = [&](const auto& batch) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
          const auto x = static_cast<int>(batch.scan_x[0][i]), y = static_cast<int>(batch.scan_y[0][i]);
          const exact::Interpolated want = attributes.at(barycentric.at(x, y));
          const double steps = 2.0 * size, bound = 0.5 + (steps + 2) * std::ldexp(1.0, -guard - 1);
          const auto see = [&](std::int64_t value, double exact, int bits) {
            const double error = static_cast<double>(value) - std::ldexp(exact, bits);
            worst.see(error / bound, "round " + std::to_string(round));
            if (guard == 10) lsb.see(error);
          };
          see(batch.interpolate_frame[0][i], want.frame[0].x, config.vector_bits);
          see(batch.interpolate_l[1][i], want.l.y, config.vector_bits);
          see(batch.interpolate_h[2][i], want.h.z, config.vector_bits);
          see(batch.interpolate_z[0][i], want.z, config.depth_bits);
        }
      };
      Golden(config, {}).draw(packets_of(config, triangle, {}, {}, size), {sink, sink});
    }
  }
}

}  // namespace
}  // namespace wrinkle
