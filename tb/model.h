// The Verilated core behind plain pins, so that the bench is built once and a model is loaded per configuration.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

namespace wrinkle {

// The top-level pins of wrinkle_core, none wider than 64 bits. Texel port b is used only with a trilinear filter.
struct Pins {
  // in
  std::uint8_t rst = 0;
  std::uint8_t packet_valid = 0;
  std::uint64_t packet_word = 0;
  std::uint8_t texel_request_ready = 0;
  std::uint8_t texel_response_valid = 0;
  std::uint64_t texel_response_a[4] = {}, texel_response_b[4] = {};
  std::uint8_t fragment_ready = 0;
  // out
  std::uint8_t packet_ready = 0;
  std::uint8_t texel_request_valid = 0;
  std::uint64_t texel_request_a = 0, texel_request_b = 0;
  std::uint8_t texel_response_ready = 0;
  std::uint8_t fragment_valid = 0;
  std::uint32_t fragment_x = 0, fragment_y = 0, fragment_z = 0;
  std::uint64_t fragment_colour = 0;
  std::uint8_t fragment_last = 0, fragment_zero = 0;
  std::uint8_t idle = 0;  // no packet held, no fragment in flight
};

// The stages of components.def, in pipeline order.
#define WRINKLE_STAGES(apply)                                                                                   \
  apply(scan) apply(interpolate) apply(perspective) apply(texture) apply(perturb) apply(normalize) apply(light) \
      apply(output)

enum class Stage : int {
#define WRINKLE_STAGE(stage) stage,
  WRINKLE_STAGES(WRINKLE_STAGE)
#undef WRINKLE_STAGE
};
inline constexpr const char* kStageNames[] = {
#define WRINKLE_STAGE(stage) #stage,
    WRINKLE_STAGES(WRINKLE_STAGE)
#undef WRINKLE_STAGE
};
inline constexpr int kStages = static_cast<int>(sizeof(kStageNames) / sizeof(kStageNames[0]));

enum class ValueIndex : int {
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, present) stage##_##name,
#include "golden/pixel/components.def"
#undef WRINKLE_VALUE
  count
};
inline constexpr int kValues = static_cast<int>(ValueIndex::count);

// A wire of at most 128 bits.
using TapWire = unsigned __int128;

// What the wires between the stages of wrinkle_core hold. A stage or value the netlist lacks has its bit clear.
struct Taps {
  std::uint32_t stages = 0;            // which stages have valid and ready wires
  std::uint32_t valid = 0, ready = 0;  // bit per stage
  std::uint64_t present = 0;           // which values have a wire
  TapWire values[kValues] = {};        // as on the wire: element 0 in the low bits, each `width` wide
};

// What a model library exports as `wrinkle_model`.
struct ModelApi {
  void* (*create)(std::uint64_t seed);  // the seed fills every register that has no reset
  void (*destroy)(void* model);
  void (*settle)(void* model, const Pins* pins);      // inputs reach the wires, no clock edge
  void (*clock)(void* model, Pins* pins);             // inputs, one whole clock, outputs
  void (*taps)(void* model, Taps* taps);              // of the settled wires
  bool (*trace_open)(void* model, const char* path);  // FST; false in a model built without
  void (*trace_close)(void* model);
};

// A loaded model with its state.
class Model {
 public:
  // Throws std::runtime_error when the library is not a model.
  Model(const std::filesystem::path& library, std::uint64_t seed);
  ~Model();
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  void settle(const Pins& pins) { api_->settle(state_, &pins); }
  void clock(Pins& pins) { api_->clock(state_, &pins); }
  void taps(Taps& taps) { api_->taps(state_, &taps); }
  void trace_open(const std::filesystem::path& path);
  void trace_close() { api_->trace_close(state_); }

 private:
  const ModelApi* api_;
  void* state_;
};

}  // namespace wrinkle
