// The packet decoder of the golden model: the first byte chooses a configuration, the others are words of the stream,
// behind a draw packet. Scalar and SIMD lanes must refuse the same streams and give the same fragments.
#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>

#include "golden/pixel/pixel.h"
#include "tb/random_config.h"
#include "tests/fuzz/fuzz.h"

namespace wrinkle::fuzz {
namespace {

constexpr std::size_t kConfigurations = 32;
constexpr int kLargestScreen = 5;  // 32 by 32 pixels, so that no triangle is long in drawing
constexpr std::size_t kMostFragments = 1024;

Config configuration(std::size_t index) {
  Config standard;
  standard.screen_bits = kLargestScreen;
  if (index == 0) return standard;
  std::mt19937_64 random(index);
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<std::uint64_t>(high - low + 1));
  };
  return random_config(between, kLargestScreen);
}

// Texels are a pattern.
Texture texture(const Shape& config, int log2_width, int log2_height) {
  Texture texture{log2_width, log2_height, config.texels, config.texel_bits, {}};
  for (int level = 0; level <= std::max(log2_width, log2_height); ++level) {
    auto& words = texture.levels.emplace_back();
    words.resize(static_cast<std::size_t>(texture.width(level) * texture.height(level) * texture.texel_words()));
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = 0x9E3779B97F4A7C15U * (i + 1);
  }
  return texture;
}

struct Stopped : std::exception {};  // enough fragments were drawn

// What came of a stream.
struct Result {
  std::vector<Fragment> fragments;
  bool refused = false;
  bool operator==(const Result&) const = default;
};

struct Machine {
  explicit Machine(std::size_t index)
      : config(configuration(index)),
        textures{texture(config, 3, 2), texture(config, 0, 0)},
        simd(config, textures, Lanes::kSimd),
        scalar(config, textures, Lanes::kScalar) {
    DrawWords draw;
    encode(config, draw, first_draw);
  }

  Result draw(Golden& golden, const std::vector<std::uint64_t>& words) {
    Result result;
    const auto keep = [&](const auto& batch) {
      for (int i = 0; i < batch.count; ++i) result.fragments.push_back(fragment(batch, i));
      if (result.fragments.size() > kMostFragments) throw Stopped();
    };
    try {
      golden.draw(words, {keep, keep});
    } catch (const std::invalid_argument&) {
      result.refused = true;
    } catch (const Stopped&) {
    }
    return result;
  }

  Shape config;
  std::vector<Texture> textures;
  Golden simd, scalar;
  std::vector<std::uint64_t> first_draw;
};

Machine& machine(std::size_t index) {
  static std::map<std::size_t, Machine> machines;
  return machines.try_emplace(index, index).first->second;
}

}  // namespace
}  // namespace wrinkle::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace wrinkle;
  if (size < 1) return 0;
  fuzz::Machine& machine = fuzz::machine(data[0] % fuzz::kConfigurations);
  std::vector<std::uint64_t> words = machine.first_draw;
  const std::size_t first = words.size();
  words.resize(first + (size - 1) / 8);
  std::memcpy(words.data() + first, data + 1, (size - 1) / 8 * 8);
  if (machine.draw(machine.simd, words) != machine.draw(machine.scalar, words))
    fuzz::fail("scalar and SIMD lanes differ");
  return 0;
}
