#include "golden/triangle/coverage.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "golden/exact/scan.h"
#include "tests/host/packet_walker.h"

namespace wrinkle {
namespace {

using test::Point;
using test::Random;
using test::triangle;

using Pixel = std::pair<int, int>;  // y, x

// The pixels that the packets of a triangle visit; fails when one comes twice, off the screen, or a packet has none.
std::vector<Pixel> pixels(const Config& config, const ScreenTriangle& t, int width, int height) {
  std::vector<Pixel> all;
  for (TriangleWords packet : set_up(config, t, DrawWords{}, width, height)) {
    std::vector<std::uint64_t> words;
    encode(config, packet, words);
    packet = decode_triangle(config, words);
    int last_row = -1;
    const std::size_t before = all.size();
    test::walk(packet, [&](const test::Visit& visit) {
      all.emplace_back(visit.y, visit.x);
      last_row = visit.y;
    });
    if (all.size() == before) {
      ADD_FAILURE() << "a packet without pixels";
      continue;
    }
    EXPECT_EQ(all[before].first, packet.y) << "an empty first row";
    EXPECT_EQ(last_row, packet.y + packet.rows - 1) << "an empty last row";
  }
  std::sort(all.begin(), all.end());
  EXPECT_EQ(std::adjacent_find(all.begin(), all.end()), all.end()) << "a pixel comes twice";
  for (const auto& [y, x] : all) EXPECT_TRUE(x >= 0 && x < width && y >= 0 && y < height) << x << ", " << y;
  return all;
}

std::vector<Pixel> exact_pixels(const Config& config, const ScreenTriangle& t, int width, int height) {
  std::vector<Pixel> all;
  exact::scan(config, sort_corners(config, t), width, height, [&](int y, int first, int end) {
    for (int x = first; x < end; ++x) all.emplace_back(y, x);
  });
  return all;
}

Config config_for(int screen_bits, int subpixel_bits = 8) {
  Config config;
  config.screen_bits = screen_bits;
  config.subpixel_bits = subpixel_bits;
  return config;
}

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
    if (exact_pixels(config, c.triangle, 64, 64) != c.pixels) ++differences;
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

Point random_point(Random& random, const Config& config, int kind) {
  const std::int64_t one = 1 << config.subpixel_bits, size = one << config.screen_bits;
  const auto any = [&](std::int64_t low, std::int64_t high, std::int64_t grid) {
    return static_cast<int>(random.integer(low, high) / grid * grid);
  };
  switch (kind) {
    case 0:  // the screen
      return {any(0, size, 1), any(0, size, 1)};
    case 1:  // the whole guard band
      return {any(-size, 2 * size - 1, 1), any(-size, 2 * size - 1, 1)};
    case 2:  // half-pixel grid, so that centres lie on corners and edges
      return {any(0, size, one / 2), any(0, size, one / 2)};
    default:  // just about the left side
      return {any(-4 * one, 4 * one, 1), any(0, size, 1)};
  }
}

TEST(Coverage, WalksEqualHalfPlanesOnRandomTriangles) {
  Random random(3);
  for (int i = 0; i < 60000; ++i) {
    const Config config = config_for(static_cast<int>(random.integer(4, 7)), static_cast<int>(random.integer(2, 8)));
    const int width = static_cast<int>(random.integer(1, config.screen_size()));
    const int height = static_cast<int>(random.integer(1, config.screen_size()));
    const auto point = [&] { return random_point(random, config, i % 4); };
    Point a = point(), b = point(), c = point();
    if (i % 5 == 0) {  // slivers and small ones
      b = {a.x + static_cast<int>(random.integer(-300, 300)), a.y + static_cast<int>(random.integer(-300, 300))};
      c = {(a.x + b.x) / 2 + static_cast<int>(random.integer(-2, 2)), (a.y + b.y) / 2};
      const int high = 2 << (config.screen_bits + config.subpixel_bits);
      for (Point* p : {&b, &c})
        p->x = std::clamp(p->x, -high / 2, high - 1), p->y = std::clamp(p->y, -high / 2, high - 1);
    }
    ASSERT_EQ(pixels(config, triangle(a, b, c), width, height), exact_pixels(config, triangle(a, b, c), width, height))
        << "triangle " << i;
  }
}

// A jittered grid: every pixel exactly once, whatever the windings and diagonals.
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

TEST(Coverage, AMirrorSavesPackets) {
  const Config config = config_for(6);
  // The corner in the middle on the left: the single edge is on the right.
  const auto packets = set_up(config, triangle({8000, 100}, {200, 6000}, {9000, 12000}), DrawWords{}, 64, 64);
  ASSERT_EQ(packets.size(), 1u);
  EXPECT_TRUE(packets[0].mirror);
  EXPECT_LT(packets[0].rows_end0, packets[0].rows);
}

TEST(Extremes, E01_ZeroArea) {
  const Config config = config_for(6);
  EXPECT_TRUE(pixels(config, triangle({0, 0}, {2560, 2560}, {10240, 10240}), 64, 64).empty());
  EXPECT_TRUE(pixels(config, triangle({128, 128}, {128, 5248}, {128, 10368}), 64, 64).empty());
  EXPECT_TRUE(pixels(config, triangle({0, 128}, {128, 128}, {12800, 128}), 64, 64).empty());
}

TEST(Extremes, E02_CoincidentVertices) {
  const Config config = config_for(6);
  EXPECT_TRUE(pixels(config, triangle({128, 128}, {128, 128}, {5000, 9000}), 64, 64).empty());
  EXPECT_TRUE(pixels(config, triangle({128, 128}, {128, 128}, {128, 128}), 64, 64).empty());
}

TEST(Extremes, E03_Sliver) {
  const Config config = config_for(12);
  Random random(5);
  const int length = 4096 * 256;
  // One sub-pixel wide, along the centres of a row, of a column and of a diagonal.
  EXPECT_EQ(pixels(config, triangle({0, 128}, {length, 128}, {0, 129}), 4096, 4096).size(), 4096u);
  EXPECT_EQ(pixels(config, triangle({128, 0}, {129, 0}, {128, length}), 4096, 4096).size(), 4096u);
  EXPECT_EQ(pixels(config, triangle({0, 0}, {1, 0}, {length, length}), 4096, 4096).size(), 4096u);
  EXPECT_EQ(pixels(config, triangle({0, 129}, {length, 129}, {0, 130}), 4096, 4096).size(), 0u);
  for (int i = 0; i < 50; ++i) {
    const Point a{static_cast<int>(random.integer(0, 512)), static_cast<int>(random.integer(0, length))};
    const Point b{length - static_cast<int>(random.integer(0, 512)), static_cast<int>(random.integer(0, length))};
    const ScreenTriangle t = triangle(a, b, {b.x, b.y + 1});
    EXPECT_EQ(pixels(config, t, 4096, 4096), exact_pixels(config, t, 4096, 4096));
  }
}

TEST(Extremes, E04_OnePixelCentreOrNone) {
  const Config config = config_for(4);
  EXPECT_EQ(pixels(config, triangle({120, 120}, {140, 124}, {122, 150}), 16, 16), std::vector<Pixel>({{0, 0}}));
  EXPECT_TRUE(pixels(config, triangle({130, 130}, {380, 130}, {130, 380}), 16, 16).empty());
}

TEST(Extremes, E05_FanAboutAPixelCentre) {
  const Config config = config_for(6);
  const Point centre{32 * 256 + 128, 32 * 256 + 128};
  // Rim and centre on pixel centres, so that many centres lie on edges.
  const int rim[][2] = {{16, 0}, {16, 8}, {8, 16}, {0, 16}, {-16, 16}, {-16, 0}, {-8, -16}, {0, -16}, {16, -16}};
  std::map<Pixel, int> count;
  for (std::size_t i = 0; i < std::size(rim); ++i) {
    const auto& a = rim[i];
    const auto& b = rim[(i + 1) % std::size(rim)];
    const ScreenTriangle t = triangle(centre, {centre.x + a[0] * 256, centre.y + a[1] * 256},
                                      {centre.x + b[0] * 256, centre.y + b[1] * 256});
    for (Pixel pixel : pixels(config, t, 64, 64)) ++count[pixel];
  }
  EXPECT_EQ((count[{32, 32}]), 1);
  for (const auto& [pixel, n] : count) EXPECT_EQ(n, 1) << pixel.second << ", " << pixel.first;
  for (int y = 17; y < 48; ++y) {
    for (int x = 31; x < 34; ++x) EXPECT_EQ((count[{y, x}]), 1) << x << ", " << y;
  }
}

TEST(Extremes, E06_LeastArea) {
  const Config config = config_for(4);
  // Twice the area is one sub-pixel squared, on the pixel centre: top-left owns it, the other winding too.
  EXPECT_EQ(pixels(config, triangle({128, 128}, {129, 128}, {128, 129}), 16, 16), std::vector<Pixel>({{0, 0}}));
  EXPECT_EQ(pixels(config, triangle({128, 128}, {128, 129}, {129, 128}), 16, 16), std::vector<Pixel>({{0, 0}}));
  EXPECT_TRUE(pixels(config, triangle({127, 127}, {128, 127}, {127, 128}), 16, 16).empty());
}

TEST(Extremes, E07_FullGuardBand) {
  for (int screen_bits : {4, 10, 12}) {
    const Config config = config_for(screen_bits);
    const int size = config.screen_size(), low = -(size << 8), high = (2 * size << 8) - 1;
    for (const ScreenTriangle& t :
         {triangle({low, low}, {high, low}, {low, high}), triangle({high, high}, {high, low}, {low, high}),
          triangle({low, low}, {high, high}, {high, high - 1}), triangle({low, high}, {high, low}, {low, high - 1})}) {
      EXPECT_EQ(pixels(config, t, size, size), exact_pixels(config, t, size, size));
    }
    EXPECT_EQ(pixels(config, triangle({low, low}, {high, low}, {low, high}), size, size).size() +
                  pixels(config, triangle({high, high}, {high, low}, {low, high}), size, size).size(),
              static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  }
}

TEST(Extremes, E08_OffScreenOnEverySideAndCorner) {
  const Config config = config_for(6);
  for (int sy = -1; sy <= 1; ++sy) {
    for (int sx = -1; sx <= 1; ++sx) {
      const int x = sx * 64 * 256, y = sy * 64 * 256;
      const auto drawn = pixels(config, triangle({x, y}, {x + 16383, y + 100}, {x + 300, y + 16383}), 64, 64);
      EXPECT_EQ(drawn.empty(), sx != 0 || sy != 0) << sx << ", " << sy;
    }
  }
}

TEST(Extremes, E09_OutsideTheGuardBandIsRefused) {
  const Config config = config_for(6);
  const int low = -(64 << 8), high = 128 << 8;
  EXPECT_NO_THROW(pixels(config, triangle({low, low}, {high - 1, 0}, {0, high - 1}), 64, 64));
  EXPECT_THROW(pixels(config, triangle({low - 1, 0}, {100, 0}, {0, 100}), 64, 64), std::invalid_argument);
  EXPECT_THROW(pixels(config, triangle({0, 0}, {high, 0}, {0, 100}), 64, 64), std::invalid_argument);
  EXPECT_THROW(pixels(config, triangle({0, 0}, {100, 0}, {0, high}), 64, 64), std::invalid_argument);
  EXPECT_THROW(pixels(config, triangle({0, 0}, {100, 0}, {0, 100}), 65, 64), std::invalid_argument);
}

TEST(Extremes, E10_E18_WindingAndOrderOfCornersDoNotMatter) {
  Random random(6);
  int drawn = 0;
  for (int i = 0; i < 500; ++i) {
    Config config = random.config();
    config.uv_integer_bits = std::max(config.uv_integer_bits, 3);
    ScreenTriangle t = triangle(random_point(random, config, i % 4), random_point(random, config, i % 4),
                                random_point(random, config, i % 4));
    test::randomize_attributes(random, t);
    DrawState state;
    state.bump = state.textured = true;
    const auto textures = test::one_texture(6, 5);
    const int size = config.screen_size();
    const auto words = set_up(config, t, state, textures, size, size);
    drawn += words.empty() ? 0 : 1;
    const int order[5][3] = {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (const auto& o : order) {
      ScreenTriangle other = t;
      for (std::size_t k = 0; k < 3; ++k) other.v[k] = t.v[static_cast<std::size_t>(o[k])];
      ASSERT_EQ(set_up(config, other, state, textures, size, size), words);
    }
  }
  EXPECT_GT(drawn, 300);
}

TEST(Extremes, E11_SpansOf1_4095_4096) {
  const Config config = config_for(12);
  for (int n : {1, 4095, 4096}) {
    const ScreenTriangle upper = triangle({0, 0}, {n * 256, 0}, {0, 256});
    const ScreenTriangle lower = triangle({n * 256, 0}, {n * 256, 256}, {0, 256});
    EXPECT_EQ(pixels(config, upper, 4096, 1).size() + pixels(config, lower, 4096, 1).size(),
              static_cast<std::size_t>(n));
    const ScreenTriangle wide = triangle({0, 0}, {n * 256, 0}, {n * 256, 512});
    EXPECT_EQ(pixels(config, wide, 4096, 2), exact_pixels(config, wide, 4096, 2));
  }
  const ScreenTriangle whole = triangle({-4096, -128}, {4096 * 256 + 4096, -128}, {2048 * 256, 1000 * 256});
  const auto row = pixels(config, whole, 4096, 1);
  EXPECT_EQ(row.size(), 4096u);
}

TEST(Extremes, E12_ScreensFrom1x1To4096x4096) {
  const Config config = config_for(12);
  const ScreenTriangle all = triangle({0, 0}, {2 * 4096 * 256 - 1, 0}, {0, 2 * 4096 * 256 - 1});
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 4096}, {4096, 1}, {4096, 4096}, {3, 5}}) {
    EXPECT_EQ(pixels(config, all, width, height).size(),
              static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    EXPECT_EQ(set_up(config, all, DrawWords{}, width, height).size(), 1u);
  }
}

}  // namespace
}  // namespace wrinkle
