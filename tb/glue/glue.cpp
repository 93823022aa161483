// Compiled with every Verilated wrinkle_core: turns the generated class into the C interface of tb/model.h.
// Nothing else sees Verilator's headers.
#include "Vwrinkle_core.h"
#include "Vwrinkle_core___024root.h"
#include "verilated.h"
#ifdef WRINKLE_TRACE
#include "verilated_fst_c.h"
#endif

#include <memory>
#include <type_traits>

#include "tb/model.h"

namespace {

using wrinkle::Pins;
using wrinkle::Taps;

struct Instance {
  explicit Instance(std::uint64_t seed) {
    context.threads(1);
    context.randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    context.randReset(2);
#ifdef WRINKLE_TRACE
    context.traceEverOn(true);
#endif
    core = std::make_unique<Vwrinkle_core>(&context);
    core->clk = 0;
  }
  ~Instance() {
    // Verilator's scopes take themselves off the thread's current context, which may be that of a later model.
    Verilated::threadContextp(&context);
    core->final();
    core.reset();
  }

  VerilatedContext context;
  std::unique_ptr<Vwrinkle_core> core;
#ifdef WRINKLE_TRACE
  std::unique_ptr<VerilatedFstC> trace;
#endif
};

Instance& instance(void* model) { return *static_cast<Instance*>(model); }

void drive(Vwrinkle_core& core, const Pins& pins) {
  core.rst = pins.rst;
  core.packet_valid_i = pins.packet_valid;
  core.packet_word_i = pins.packet_word;
  core.texel_request_ready_i = pins.texel_request_ready;
  core.texel_response_valid_i = pins.texel_response_valid;
  core.fragment_ready_i = pins.fragment_ready;
  core.texel_a00_i = static_cast<decltype(core.texel_a00_i + 0)>(pins.texel_response_a[0]);
  core.texel_a10_i = static_cast<decltype(core.texel_a10_i + 0)>(pins.texel_response_a[1]);
  core.texel_a01_i = static_cast<decltype(core.texel_a01_i + 0)>(pins.texel_response_a[2]);
  core.texel_a11_i = static_cast<decltype(core.texel_a11_i + 0)>(pins.texel_response_a[3]);
  core.texel_b00_i = static_cast<decltype(core.texel_b00_i + 0)>(pins.texel_response_b[0]);
  core.texel_b10_i = static_cast<decltype(core.texel_b10_i + 0)>(pins.texel_response_b[1]);
  core.texel_b01_i = static_cast<decltype(core.texel_b01_i + 0)>(pins.texel_response_b[2]);
  core.texel_b11_i = static_cast<decltype(core.texel_b11_i + 0)>(pins.texel_response_b[3]);
}

void read(const Vwrinkle_core& core, Pins& pins) {
  pins.packet_ready = core.packet_ready_o;
  pins.texel_request_valid = core.texel_request_valid_o;
  pins.texel_request_a = core.texel_request_a_o;
  pins.texel_request_b = core.texel_request_b_o;
  pins.texel_response_ready = core.texel_response_ready_o;
  pins.fragment_valid = core.fragment_valid_o;
  pins.fragment_x = core.fragment_x_o;
  pins.fragment_y = core.fragment_y_o;
  pins.fragment_z = core.fragment_z_o;
  pins.fragment_colour = core.fragment_colour_o;
  pins.fragment_last = core.fragment_last_o;
  pins.fragment_zero = core.fragment_zero_o;
  pins.idle = core.idle_o;
}

#ifdef WRINKLE_TRACE
void dump(Instance& model) {
  if (model.trace) model.trace->dump(model.context.time());
  model.context.timeInc(1);
}
#else
void dump(Instance&) {}
#endif

// The falling edge changes nothing but the clock. Verilator needs to know of it before the next rising one, but need not
// evaluate the model for it.
void fall(Vwrinkle_core& core) {
  core.clk = 0;
  core.rootp->__Vtrigrprev__TOP__clk = 0;
}

// What is wider than 64 bits is a VlWide of 32-bit words.
template <class Wire>
wrinkle::TapWire whole(const Wire& wire) {
  if constexpr (std::is_integral_v<Wire>) {
    return static_cast<std::uint64_t>(wire);
  } else {
    wrinkle::TapWire value = 0;
    for (std::size_t word = sizeof(Wire) / 4; word-- > 0;) value = value << 32 | wire[word];
    return value;
  }
}

// A template, so that a wire the configuration lacks is skipped instead of an error.
template <class Root>
void sample(const Root& root, Taps& taps) {
#define WRINKLE_STAGE(stage)                                                     \
  if constexpr (requires {                                                       \
                  root.wrinkle_core__DOT__##stage##_valid;                       \
                  root.wrinkle_core__DOT__##stage##_ready;                       \
                }) {                                                             \
    constexpr std::uint32_t bit = 1U << static_cast<int>(wrinkle::Stage::stage); \
    taps.stages |= bit;                                                          \
    if (root.wrinkle_core__DOT__##stage##_valid) taps.valid |= bit;              \
    if (root.wrinkle_core__DOT__##stage##_ready) taps.ready |= bit;              \
  }
  WRINKLE_STAGES(WRINKLE_STAGE)
#undef WRINKLE_STAGE
#define WRINKLE_VALUE(stage, name, elements, width, fraction_bits, is_signed, is_present) \
  if constexpr (requires { root.wrinkle_core__DOT__##stage##_##name; }) {                 \
    constexpr int index = static_cast<int>(wrinkle::ValueIndex::stage##_##name);          \
    taps.present |= 1ULL << index;                                                        \
    taps.values[index] = whole(root.wrinkle_core__DOT__##stage##_##name);                 \
  }
#include "golden/pixel/components.def"
#undef WRINKLE_VALUE
}

void* create(std::uint64_t seed) { return new Instance(seed); }

void destroy(void* model) { delete static_cast<Instance*>(model); }

void settle(void* model, const Pins* pins) {
  drive(*instance(model).core, *pins);
  instance(model).core->eval();
}

void clock(void* model, Pins* pins) {
  Instance& self = instance(model);
  drive(*self.core, *pins);
  self.core->clk = 1;
  self.core->eval();
  dump(self);
  fall(*self.core);
  dump(self);
  read(*self.core, *pins);
}

void sample_taps(void* model, Taps* taps) {
  *taps = Taps{};
  sample(*instance(model).core->rootp, *taps);
}

#ifdef WRINKLE_TRACE
bool trace_open(void* model, const char* path) {
  Instance& self = instance(model);
  self.trace = std::make_unique<VerilatedFstC>();
  self.core->trace(self.trace.get(), 99);
  self.trace->open(path);
  return true;
}

void trace_close(void* model) {
  if (!instance(model).trace) return;
  instance(model).trace->close();
  instance(model).trace.reset();
}
#else
bool trace_open(void*, const char*) { return false; }
void trace_close(void*) {}
#endif

}  // namespace

extern "C" __attribute__((visibility("default")))
const wrinkle::ModelApi wrinkle_model{create, destroy, settle, clock, sample_taps, trace_open, trace_close};
