// The Verilated core behind plain pins, so that the bench is built once and a model is loaded per configuration.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "tb/pins.h"

namespace wrinkle {

// A wire of wrinkle_core as it lies in the memory of the model, bit 0 in the low bit of the first byte. It is up to
// date whenever the model is settled, and stays in its place while the model lives.
struct Wire {
  const char* name = "";
  const unsigned char* data = nullptr;
  std::size_t bytes = 0;
};

// A signal that the bench adds to a waveform beside those of the netlist.
struct TraceSignal {
  std::string name;           // with its scopes, divided by dots
  int bits = 0;               // of `integer`; 0: the signal is `number`
  std::uint64_t integer = 0;  // at the clock that is written
  double number = 0;
};

// A waveform is a file in FST. Clock N, with the wires as they are before its edge, is N nanoseconds after its start.
struct TraceRequest {
  const char* path;
  std::uint64_t clock;         // the next one
  const TraceSignal* signals;  // stay in their place until the waveform is closed
  std::size_t count;
};

// What a model library exports as `wrinkle_model`.
struct ModelApi {
  void* (*create)(std::uint64_t seed);  // the seed fills every register that has no reset
  void (*destroy)(void* model);
  void (*settle)(void* model, const InputPins* pins);  // inputs reach the wires, no clock edge
  void (*clock)(void* model, Pins* pins);              // inputs, one whole clock, outputs
  const Wire* (*wires)(void* model, std::size_t* count);
  bool (*trace_open)(void* model, const TraceRequest* request);  // false in a model built without
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

  void settle(const InputPins& pins) { api_->settle(state_, &pins); }
  void clock(Pins& pins) { api_->clock(state_, &pins); }
  // Those of visible_wires() that the netlist has.
  std::span<const Wire> wires() const;
  // Null data where the netlist has no such wire.
  Wire wire(std::string_view name) const;
  void trace_open(const std::filesystem::path& path, std::uint64_t clock, std::span<const TraceSignal> signals);
  void trace_close() { api_->trace_close(state_); }

 private:
  const ModelApi* api_;
  void* state_;
};

}  // namespace wrinkle
