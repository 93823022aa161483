// The packet decoder of the golden model: the first byte chooses a configuration, the others are words of the stream,
// behind a draw packet. Scalar and SIMD lanes must refuse the same streams and give the same fragments.
#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "golden/pixel/pixel.h"
#include "tests/fuzz/fuzz.h"

namespace wrinkle::fuzz {
namespace {

constexpr int kScreenBits = 5;  // 32 by 32 pixels, so that no triangle is long in drawing
constexpr std::size_t kMostFragments = 1024;

// Inputs name a configuration by its place here: new ones go to the end.
const std::vector<Config>& configurations() {
  using C = Config;
  using Changes = std::vector<std::pair<int Config::*, int>>;
  static const std::vector<Changes> kChanges{
      {},
      {{&C::datapath, 0}, {&C::decal, 1}},
      {{&C::datapath, 0}, {&C::filter, 0}, {&C::perspective, 1}, {&C::decal, 1}},
      {{&C::datapath, 2}, {&C::perspective, 1}, {&C::gloss_map, 1}},
      {{&C::datapath, 2}, {&C::cross_products, 1}, {&C::filter, 1}},
      {{&C::datapath, 3}},
      {{&C::datapath, 4}, {&C::decal, 1}},
      {{&C::light_vectors, 1}, {&C::decode, 1}},
      {{&C::light_vectors, 1}, {&C::lighting, 2}, {&C::perspective, 1}},
      {{&C::lighting, 3}, {&C::self_shadow, 2}, {&C::decal, 1}, {&C::gloss_map, 1}},
      {{&C::normalize_order, 1}, {&C::self_shadow, 0}, {&C::perspective, 1}},
      {{&C::normalize_order, 1}, {&C::self_shadow, 0}, {&C::lighting, 0}, {&C::vector_bits, 7}},
      {{&C::lighting, 0}, {&C::channels, 0}, {&C::depth, 0}, {&C::normalizer_n, 0}, {&C::normalizer_l, 0}},
      {{&C::normalizer_n, 2}, {&C::normalizer_l, 3}, {&C::normalizer_h, 4}, {&C::weight_bits, 1}, {&C::lod_bits, 0}},
      {{&C::vector_bits, 18},
       {&C::unit_bits, 16},
       {&C::dot_bits, 16},
       {&C::power_bits, 18},
       {&C::texel_bits, 10},
       {&C::uv_bits, 24},
       {&C::uv_integer_bits, 10},
       {&C::guard_bits, 14},
       {&C::specular_squarings, 8},
       {&C::perspective, 1},
       {&C::q_bits, 21},
       {&C::reciprocal_bits, 20},
       {&C::decal, 1}},
      {{&C::vector_bits, 5},
       {&C::unit_bits, 6},
       {&C::dot_bits, 6},
       {&C::power_bits, 6},
       {&C::texel_bits, 4},
       {&C::uv_bits, 8},
       {&C::uv_integer_bits, 1},
       {&C::guard_bits, 2},
       {&C::specular_squarings, 0},
       {&C::colour_bits, 4},
       {&C::depth_bits, 8}}};
  static const std::vector<Config> kConfigurations = [] {
    std::vector<Config> list;
    for (const Changes& changes : kChanges) {
      Config& config = list.emplace_back();
      config.screen_bits = kScreenBits;
      for (const auto& [member, value] : changes) config.*member = value;
      if (!check(config).key.empty()) fail("configuration " + std::to_string(list.size() - 1) + " is not legal");
    }
    return list;
  }();
  return kConfigurations;
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
      : config(configurations()[index]),
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
  fuzz::Machine& machine = fuzz::machine(data[0] % fuzz::configurations().size());
  std::vector<std::uint64_t> words = machine.first_draw;
  const std::size_t first = words.size();
  words.resize(first + (size - 1) / 8);
  std::memcpy(words.data() + first, data + 1, (size - 1) / 8 * 8);
  if (machine.draw(machine.simd, words) != machine.draw(machine.scalar, words))
    fuzz::fail("scalar and SIMD lanes differ");
  return 0;
}
