#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "tests/host/spans.h"

namespace wrinkle {
namespace {

using namespace test;

TEST(Coverage, EqualsTheTopLeftVectors) {
  const std::string path = std::string(WRINKLE_SHARED_DIR) + "/assets/vectors/coverage_topleft_64x64.txt";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  struct Case {
    ScreenTriangle triangle;
    std::vector<Pixel> pixels;
  };
  std::vector<Case> cases;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string tag;
    words >> tag;
    if (tag == "T") {
      int id, kind;
      Point a, b, c;
      words >> id >> kind >> a.x >> a.y >> b.x >> b.y >> c.x >> c.y;
      cases.push_back({triangle(a, b, c), {}});
    } else if (tag == "R") {
      int y;
      std::uint64_t mask;
      words >> y >> std::hex >> mask;
      for (int x = 0; x < 64; ++x) {
        if (mask >> x & 1) cases.back().pixels.emplace_back(y, x);
      }
    }
  }
  ASSERT_EQ(cases.size(), 1440u);
  const Config config = config_for(6);
  int differences = 0;
  for (const Case& c : cases) {
    if (pixels(config, c.triangle, 64, 64) != c.pixels) ++differences;
    if (to_pixels(exact_spans(config, c.triangle, 64, 64)) != c.pixels) ++differences;
  }
  EXPECT_EQ(differences, 0);
}

// learn.microsoft.com, "Rasterization Rules (Direct3D 9)": pixel centres at integers there, hence the half pixels.
TEST(Coverage, EqualsTheCountsPublishedForDirect3D9) {
  const Config config = config_for(4);
  const auto at = [](double x, double y) {
    return Point{static_cast<int>((x + 0.5) * 256), static_cast<int>((y + 0.5) * 256)};
  };
  const auto t1 = pixels(config, triangle(at(0, 0), at(5, 0), at(5, 5)), 16, 16);
  const auto t2 = pixels(config, triangle(at(0, 5), at(0, 0), at(5, 5)), 16, 16);
  EXPECT_EQ(t1.size(), 15u);
  EXPECT_EQ(t2.size(), 10u);
  std::set<Pixel> both(t1.begin(), t1.end());
  both.insert(t2.begin(), t2.end());
  EXPECT_EQ(both.size(), 25u);

  const auto fan = [&](double x, double y) {
    const Point corner[4] = {at(x, y), at(x + 2, y), at(x + 2, y + 4), at(x, y + 4)};
    std::multiset<Pixel> all;
    for (int i = 0; i < 4; ++i) {
      for (Pixel pixel : pixels(config, triangle(corner[i], corner[(i + 1) % 4], at(x + 1, y + 2)), 16, 16)) {
        all.insert(pixel);
      }
    }
    return all;
  };
  EXPECT_EQ(fan(0.5, 0.5).size(), 8u);
  EXPECT_EQ(fan(0.5, 0.5), fan(1, 1));
}

TEST(Coverage, WalksEqualHalfPlanesOnRandomTriangles) {
  Random random(3);
  for (int i = 0; i < 60000; ++i) {
    const Config config = config_for(static_cast<int>(random.integer(4, 7)), static_cast<int>(random.integer(2, 8)));
    const int width = static_cast<int>(random.integer(1, config.screen_size()));
    const int height = static_cast<int>(random.integer(1, config.screen_size()));
    const auto point = [&] { return random_point(random, config, i % 4); };
    Point a = point(), b = point(), c = point();
    if (i % 5 == 0) {  // small ones
      b = {a.x + static_cast<int>(random.integer(-300, 300)), a.y + static_cast<int>(random.integer(-300, 300))};
    }
    if (i % 5 <= 2) {  // slivers, empty in most rows; long ones are cut at the sides of the screen
      c = {(a.x + b.x) / 2 + static_cast<int>(random.integer(-2, 2)), (a.y + b.y) / 2};
    }
    const int high = 2 << (config.screen_bits + config.subpixel_bits);
    for (Point* p : {&b, &c}) {
      p->x = std::clamp(p->x, -high / 2, high - 1), p->y = std::clamp(p->y, -high / 2, high - 1);
    }
    ASSERT_EQ(spans(config, triangle(a, b, c), width, height), exact_spans(config, triangle(a, b, c), width, height))
        << "triangle " << i;
  }
}

// The triangles of a jittered grid draw every pixel exactly once, whatever their windings and diagonals.
TEST(Coverage, SharedEdgesAreDrawnOnce) {
  Random random(4);
  const Config config = config_for(6);
  for (int round = 0; round < 20; ++round) {
    constexpr int kCells = 8;
    std::vector<Point> points;
    for (int j = 0; j <= kCells; ++j) {
      for (int i = 0; i <= kCells; ++i) {
        // Odd rounds keep to the half-pixel grid, so that centres lie on edges and corners.
        const int grid = round % 2 == 0 ? 1 : 128;
        const auto jitter = [&](int k) {
          return k == 0 || k == kCells ? 0 : static_cast<int>(random.integer(-500, 500)) / grid * grid;
        };
        points.push_back({i * 2048 + jitter(i), j * 2048 + jitter(j)});
      }
    }
    std::vector<int> count(64 * 64);
    for (int j = 0; j < kCells; ++j) {
      for (int i = 0; i < kCells; ++i) {
        const auto p = [&](int di, int dj) {
          return points[static_cast<std::size_t>((j + dj) * (kCells + 1) + i + di)];
        };
        for (const ScreenTriangle& t : {triangle(p(0, 0), p(1, 0), p(1, 1)), triangle(p(1, 1), p(0, 0), p(0, 1))}) {
          for (const auto& [y, x] : pixels(config, t, 64, 64)) ++count[static_cast<std::size_t>(y * 64 + x)];
        }
      }
    }
    for (int n : count) ASSERT_EQ(n, 1);
  }
}

// Slivers that the right side of the screen cuts so that a piece would begin or end with an empty row. These are three
// from some eight million random triangles.
TEST(Coverage, PiecesAreTrimmed) {
  for (const auto& [bits, width, a, b, c] : {std::tuple{6, 5, Point{208, 333}, Point{1089, 1959}, Point{232, 536}},
                                             {6, 7, Point{339, 750}, Point{477, 610}, Point{576, 66}},
                                             {2, 6, Point{16, 54}, Point{43, -37}, Point{24, 43}}}) {
    const Config config = config_for(4, bits);
    EXPECT_EQ(spans(config, triangle(a, b, c), width, 16), exact_spans(config, triangle(a, b, c), width, 16));
  }
}

TEST(Coverage, AMirrorSavesPackets) {
  const Config config = config_for(6);
  // The middle corner is on the left, so the single edge is on the right.
  const auto packets = set_up(config, triangle({8000, 100}, {200, 6000}, {9000, 12000}), DrawWords{}, 64, 64);
  ASSERT_EQ(packets.size(), 1u);
  EXPECT_TRUE(packets[0].mirror);
  EXPECT_LT(packets[0].rows_end0, packets[0].rows);
}

}  // namespace
}  // namespace wrinkle
