// scan: the pixels of a packet are those of the three half-planes, in walk order, and the last one is marked.
#include <set>

#include "golden/pixel/row_engine.h"
#include "tests/stage/walk.h"

namespace wrinkle {
namespace {

using Pixels = std::set<std::pair<int, int>>;

struct Drawn {
  Pixels pixels;
  std::vector<std::array<std::int64_t, 3>> sequence;  // x, y, last
  std::vector<std::uint32_t> packet;
  std::vector<int> batches;
};

Drawn draw(const Config& config, const std::vector<std::uint64_t>& words, const std::vector<Texture>& textures,
           Lanes lanes) {
  Drawn drawn;
  const auto sink = [&](const auto& batch) {
    drawn.batches.push_back(batch.count);
    for (int i = 0; i < batch.count; ++i) {
      const Fragment f = fragment(batch, i);
      EXPECT_TRUE(drawn.pixels.emplace(f.x, f.y).second) << "pixel " << f.x << ' ' << f.y << " is drawn twice";
      drawn.sequence.push_back({f.x, f.y, f.last});
      drawn.packet.push_back(batch.packet[static_cast<std::size_t>(i)]);
    }
  };
  Golden(config, textures, lanes).draw(words, {sink, sink});
  return drawn;
}

TEST(Scan, CoversTheHalfPlanes) {
  Random random(base_seed());
  const Config config;
  int covered = 0;
  for (int round = 0; round < 1500; ++round) {
    const int size = round % 3 == 0 ? 200 : 24;
    const ScreenTriangle triangle = random_triangle(config, random, size);
    Pixels want;
    exact::scan(config, sort_corners(config, triangle), size, size, [&](int y, int first, int end) {
      for (int x = first; x < end; ++x) want.emplace(x, y);
    });
    const auto words = packets_of(config, triangle, {}, {}, size);
    const auto drawn = draw(config, words, {}, Lanes::kSimd);
    ASSERT_EQ(drawn.pixels, want) << "round " << round << ", seed " << base_seed();
    ASSERT_EQ(draw(config, words, {}, Lanes::kChecked).sequence, drawn.sequence);
    covered += static_cast<int>(want.size());
    for (std::size_t i = 0; i < drawn.sequence.size(); ++i) {
      const bool is_last = i + 1 == drawn.sequence.size() || drawn.packet[i + 1] != drawn.packet[i];
      ASSERT_EQ(drawn.sequence[i][2], is_last) << "fragment " << i << " of round " << round;
    }
  }
  EXPECT_GT(covered, 100000);
}

// Batches are full but for the last of a draw, and a draw packet flushes.
TEST(Scan, BatchesAreFull) {
  const Config config;
  Random random(base_seed());
  std::vector<std::uint64_t> words;
  ScreenTriangle triangle = random_triangle(config, random, 64);
  triangle.v[0].x = triangle.v[0].y = triangle.v[1].y = triangle.v[2].x = 0;
  triangle.v[1].x = triangle.v[2].y = 64 << config.subpixel_bits;
  for (int i = 0; i < 2; ++i) {
    const auto draw_words = packets_of(config, triangle, {}, {}, 64);
    words.insert(words.end(), draw_words.begin(), draw_words.end());
  }
  std::vector<int> counts;
  const auto sink = [&](const auto& batch) { counts.push_back(batch.count); };
  Golden(config, {}).draw(words, {sink, sink});
  const int each =
      static_cast<int>(draw(config, packets_of(config, triangle, {}, {}, 64), {}, Lanes::kSimd).pixels.size());
  EXPECT_NEAR(each, 64 * 64 / 2, 64);
  std::vector<int> want;
  for (int i = 0; i < 2; ++i) {
    want.insert(want.end(), static_cast<std::size_t>(each / kBatch), kBatch);
    if (each % kBatch != 0) want.push_back(each % kBatch);
  }
  EXPECT_EQ(counts, want);
}

// A packet written by hand: both end edges, remainders, mirroring, an empty first row.
TEST(Scan, FollowsThePacket) {
  const Config config;
  TriangleWords t(config);
  t.y = 5;
  t.rows = 4;
  t.rows_end0 = 2;
  t.start = {3, 0, -2, 1, 3};  // 3 3 4 4: carries when the remainder reaches 0
  t.end0 = {3, 2, -1, 0, 1};   // 3 5
  t.end1 = {7, -2, -1, 0, 1};  // 7 5
  const std::vector<std::array<std::int64_t, 3>> want{{3, 6, 0}, {4, 6, 0}, {4, 7, 0}, {5, 7, 0}, {6, 7, 0}, {4, 8, 1}};
  for (bool mirror : {false, true}) {
    t.mirror = mirror;
    if (mirror) t.start.w -= 100, t.end0.w -= 100, t.end1.w -= 100;
    std::vector<std::uint64_t> words;
    encode(config, DrawWords{}, words);
    encode(config, t, words);
    auto expected = want;
    if (mirror)
      for (auto& pixel : expected) pixel[0] = -1 - (pixel[0] - 100);
    EXPECT_EQ(draw(config, words, {}, Lanes::kSimd).sequence, expected);
    EXPECT_EQ(draw(config, words, {}, Lanes::kScalar).sequence, expected);
  }
}

TEST(Scan, RejectsWordsCutShort) {
  const Config config;
  std::vector<std::uint64_t> words;
  encode(config, TriangleWords(config), words);
  words.pop_back();
  EXPECT_THROW(Golden(config, {}).draw(words, {}), std::invalid_argument);
}

}  // namespace
}  // namespace wrinkle
