// Compiled with every Verilated wrinkle_core: turns the generated class into the C interface of tb/model.h.
// Nothing else sees Verilator's headers.
#include "Vwrinkle_core.h"
#include "Vwrinkle_core___024root.h"
#include "verilated.h"
#ifdef WRINKLE_TRACE
#include "verilated_fst_c.h"
#endif

#include <bit>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "tb/model.h"

static_assert(std::endian::native == std::endian::little, "wires are read byte by byte");

namespace {

using wrinkle::InputPins;
using wrinkle::OutputPins;
using wrinkle::Pins;
using wrinkle::Wire;

// A template, so that a wire the netlist lacks is skipped instead of an error.
template <class Root>
std::vector<Wire> visible_wires(const Root& root) {
  std::vector<Wire> found;
#define WRINKLE_WIRE(name)                                                                \
  if constexpr (requires { root.wrinkle_core__DOT__##name; }) {                           \
    const auto& wire = root.wrinkle_core__DOT__##name;                                    \
    found.push_back({#name, reinterpret_cast<const unsigned char*>(&wire), sizeof wire}); \
  }
#include "wires.def"
#undef WRINKLE_WIRE
  return found;
}

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
    core->eval();
    wires = visible_wires(*core->rootp);
  }
  ~Instance() {
    // Verilator's scopes take themselves off the thread's current context, which may be that of a later model.
    Verilated::threadContextp(&context);
    core->final();
    core.reset();
  }

  VerilatedContext context;
  std::unique_ptr<Vwrinkle_core> core;
  std::vector<Wire> wires;
#ifdef WRINKLE_TRACE
  std::unique_ptr<VerilatedFstC> trace;
  wrinkle::TraceRequest request{};
  std::uint32_t code = 0;  // of the first added signal; each has two
#endif
};

Instance& instance(void* model) { return *static_cast<Instance*>(model); }

// Ports of up to 64 bits are integers of Verilator's choice, wider ones arrays of 32-bit words.
std::uint64_t word(std::uint64_t pin, std::size_t) { return pin; }
template <std::size_t n>
std::uint64_t word(const std::array<std::uint64_t, n>& pin, std::size_t index) {
  return pin[index];
}
void set_word(std::uint64_t& pin, std::size_t, std::uint64_t value) { pin = value; }
template <std::size_t n>
void set_word(std::array<std::uint64_t, n>& pin, std::size_t index, std::uint64_t value) {
  pin[index] = value;
}

template <class Port, class Pin>
void to_port(Port& port, const Pin& pin) {
  if constexpr (std::is_integral_v<Port>) {
    port = static_cast<Port>(word(pin, 0));
  } else {
    static_assert(sizeof(Port) <= sizeof(Pin), "the port is wider than streams.def allows");
    for (std::size_t k = 0; k < sizeof(Port) / 4; ++k)
      port[k] = static_cast<std::uint32_t>(word(pin, k / 2) >> (k % 2 * 32));
  }
}

template <class Port, class Pin>
void from_port(const Port& port, Pin& pin) {
  if constexpr (std::is_integral_v<Port>) {
    set_word(pin, 0, port);
  } else {
    static_assert(sizeof(Port) <= sizeof(Pin), "the port is wider than streams.def allows");
    for (std::size_t k = 0; k < sizeof(Port) / 4; k += 2) {
      const std::uint64_t high = k + 1 < sizeof(Port) / 4 ? port[k + 1] : 0;
      set_word(pin, k / 2, high << 32 | port[k]);
    }
  }
}

void drive(Vwrinkle_core& core, const InputPins& pins) {
  core.rst = pins.rst;
#define WRINKLE_INPUT(stream, stage) core.stream##_valid_i = pins.stream##_valid;
#define WRINKLE_INPUT_FIELD(stream, name, most, width) to_port(core.name##_i, pins.name);
#define WRINKLE_OUTPUT(stream, stage) core.stream##_ready_i = pins.stream##_ready;
#include "golden/streams.def"
}

void read(const Vwrinkle_core& core, OutputPins& pins) {
#define WRINKLE_INPUT(stream, stage) pins.stream##_ready = core.stream##_ready_o;
#define WRINKLE_OUTPUT(stream, stage) pins.stream##_valid = core.stream##_valid_o;
#define WRINKLE_OUTPUT_FIELD(stream, name, most, width) \
  if (pins.stream##_valid != 0) from_port(core.name##_o, pins.name);
#define WRINKLE_STATUS(name) pins.name = core.name##_o;
#include "golden/streams.def"
}

#ifdef WRINKLE_TRACE
constexpr std::uint64_t kClock = 1000;  // in picoseconds, Verilator's unit

// The wires as they are before the edge, under a clock that is high in the first half.
void dump(Instance& model) {
  if (!model.trace) return;
  model.core->eval();
  const std::uint64_t start = kClock * model.request.clock++;
  model.core->clk = 1;
  model.trace->dump(start);
  model.core->clk = 0;
  model.core->eval();  // else Verilator takes it that nothing has changed
  model.trace->dump(start + kClock / 2);
}

void declare_added(void* user, VerilatedFst* trace, std::uint32_t code) {
  Instance& model = *static_cast<Instance*>(user);
  model.code = code;
  for (std::size_t i = 0; i < model.request.count; ++i, code += 2) {
    const wrinkle::TraceSignal& signal = model.request.signals[i];
    std::string name = signal.name;
    for (char& c : name) c = c == '.' ? ' ' : c;  // Verilator's own divider of scopes
    if (signal.bits == 0) trace->declDouble(code, name.c_str(), -1, FST_VD_IMPLICIT, FST_VT_VCD_REAL, false, -1);
    if (signal.bits == 1) trace->declBit(code, name.c_str(), -1, FST_VD_IMPLICIT, FST_VT_VCD_WIRE, false, -1);
    if (signal.bits > 1)
      trace->declQuad(code, name.c_str(), -1, FST_VD_IMPLICIT, FST_VT_VCD_WIRE, false, -1, signal.bits - 1, 0);
  }
}

template <bool all>
void dump_added(void* user, VerilatedFst::Buffer* buffer) {
  const Instance& model = *static_cast<Instance*>(user);
  std::uint32_t code = model.code;
  for (std::size_t i = 0; i < model.request.count; ++i, code += 2) {
    const wrinkle::TraceSignal& signal = model.request.signals[i];
    std::uint32_t* const old = buffer->oldp(code);
    if (signal.bits == 0) all ? buffer->fullDouble(old, signal.number) : buffer->chgDouble(old, signal.number);
    if (signal.bits == 1) all ? buffer->fullBit(old, signal.integer != 0) : buffer->chgBit(old, signal.integer != 0);
    if (signal.bits > 1)
      all ? buffer->fullQData(old, signal.integer, signal.bits) : buffer->chgQData(old, signal.integer, signal.bits);
  }
}

void evaluate_inputs(Instance& model) { model.core->eval(); }

// The falling edge changes nothing but the clock. Verilator needs to know of it before the next rising one, but need
// not evaluate the model for it.
void tick(Instance& model) {
  dump(model);
  model.core->clk = 1;
  model.core->eval();
  model.core->clk = 0;
  model.core->rootp->__Vtrigrprev__TOP__clk = 0;
}
#else
// eval() evaluates what depends on inputs in every clock, and looks for edges of the clock. Here both are known: these
// are the two functions of Verilator that it comes to.
void evaluate_inputs(Instance& model) {
  model.core->rootp->__VicoTriggered.at(0) = true;
  Vwrinkle_core___024root___eval_ico(model.core->rootp);
}

void tick(Instance& model) {
  model.core->rootp->__VnbaTriggered.at(0) = true;
  Vwrinkle_core___024root___eval_nba(model.core->rootp);
}
#endif

void* create(std::uint64_t seed) { return new Instance(seed); }

void destroy(void* model) { delete static_cast<Instance*>(model); }

void settle(void* model, const InputPins* pins) {
  drive(*instance(model).core, *pins);
  evaluate_inputs(instance(model));
}

void clock(void* model, Pins* pins) {
  Instance& self = instance(model);
  if (pins->are_new) {
    settle(model, pins);
    pins->are_new = false;
  }
  tick(self);
  read(*self.core, *pins);
}

const Wire* wires(void* model, std::size_t* count) {
  *count = instance(model).wires.size();
  return instance(model).wires.data();
}

#ifdef WRINKLE_TRACE
bool trace_open(void* model, const wrinkle::TraceRequest* request) {
  Instance& self = instance(model);
  self.request = *request;
  self.trace = std::make_unique<VerilatedFstC>();
  self.core->trace(self.trace.get(), 99);
  self.trace->spTrace()->addInitCb(declare_added, &self);
  self.trace->spTrace()->addFullCb(dump_added<true>, &self);
  self.trace->spTrace()->addChgCb(dump_added<false>, &self);
  self.trace->open(request->path);
  return true;
}

void trace_close(void* model) {
  if (!instance(model).trace) return;
  instance(model).trace->close();
  instance(model).trace.reset();
}
#else
bool trace_open(void*, const wrinkle::TraceRequest*) { return false; }
void trace_close(void*) {}
#endif

}  // namespace

extern "C" __attribute__((visibility("default")))
const wrinkle::ModelApi wrinkle_model{create, destroy, settle, clock, wires, trace_open, trace_close};
