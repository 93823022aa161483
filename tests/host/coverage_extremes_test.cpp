// ../shared/EXTREMES.md 1 to 12 and 18, as far as they concern set-up. Each test carries its number.
#include <gtest/gtest.h>

#include <map>
#include <stdexcept>

#include "tests/host/spans.h"

namespace wrinkle {
namespace {

using namespace test;

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
  // Triangles one sub-pixel wide, which run along the pixel centres of a row, of a column and of a diagonal.
  EXPECT_EQ(area(spans(config, triangle({0, 128}, {length, 128}, {0, 129}), 4096, 4096)), 4096u);
  EXPECT_EQ(area(spans(config, triangle({128, 0}, {129, 0}, {128, length}), 4096, 4096)), 4096u);
  EXPECT_EQ(area(spans(config, triangle({0, 0}, {1, 0}, {length, length}), 4096, 4096)), 4096u);
  EXPECT_EQ(area(spans(config, triangle({0, 129}, {length, 129}, {0, 130}), 4096, 4096)), 0u);
  for (int i = 0; i < 50; ++i) {
    const Point a{static_cast<int>(random.integer(0, 512)), static_cast<int>(random.integer(0, length))};
    const Point b{length - static_cast<int>(random.integer(0, 512)), static_cast<int>(random.integer(0, length))};
    const ScreenTriangle t = triangle(a, b, {b.x, b.y + 1});
    EXPECT_EQ(spans(config, t, 4096, 4096), exact_spans(config, t, 4096, 4096));
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
  // The rim and the middle of the fan lie on pixel centres, so that many centres lie on edges.
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
  // Twice the area of this triangle is one sub-pixel squared, and it lies on a pixel centre. The top-left rule gives it
  // the pixel, in either winding.
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
      EXPECT_EQ(spans(config, t, size, size), exact_spans(config, t, size, size));
    }
    EXPECT_EQ(area(spans(config, triangle({low, low}, {high, low}, {low, high}), size, size)) +
                  area(spans(config, triangle({high, high}, {high, low}, {low, high}), size, size)),
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
    EXPECT_EQ(area(spans(config, upper, 4096, 1)) + area(spans(config, lower, 4096, 1)), static_cast<std::size_t>(n));
    const ScreenTriangle wide = triangle({0, 0}, {n * 256, 0}, {n * 256, 512});
    EXPECT_EQ(spans(config, wide, 4096, 2), exact_spans(config, wide, 4096, 2));
  }
  const ScreenTriangle whole = triangle({-4096, -128}, {4096 * 256 + 4096, -128}, {2048 * 256, 1000 * 256});
  EXPECT_EQ(spans(config, whole, 4096, 1), Spans({{0, 0, 4096}}));
}

TEST(Extremes, E12_ScreensFrom1x1To4096x4096) {
  const Config config = config_for(12);
  const ScreenTriangle all = triangle({0, 0}, {2 * 4096 * 256 - 1, 0}, {0, 2 * 4096 * 256 - 1});
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 4096}, {4096, 1}, {4096, 4096}, {3, 5}}) {
    EXPECT_EQ(area(spans(config, all, width, height)),
              static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    EXPECT_EQ(set_up(config, all, DrawWords{}, width, height).size(), 1u);
  }
}

}  // namespace
}  // namespace wrinkle
