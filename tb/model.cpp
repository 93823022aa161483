#include "tb/model.h"

#include <dlfcn.h>

#include <stdexcept>

namespace wrinkle {

// Libraries stay loaded: a Verilated model registers per-thread state that must outlive it, and reloading is waste.
Model::Model(const std::filesystem::path& library, std::uint64_t seed) {
  void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw std::runtime_error(std::string("cannot load the model: ") + dlerror());
  api_ = static_cast<const ModelApi*>(dlsym(handle, "wrinkle_model"));
  if (api_ == nullptr) throw std::runtime_error(library.string() + ": not a model of wrinkle_core");
  state_ = api_->create(seed);
}

Model::~Model() { api_->destroy(state_); }

std::span<const Wire> Model::wires() const {
  std::size_t count = 0;
  const Wire* const first = api_->wires(state_, &count);
  return {first, count};
}

Wire Model::wire(std::string_view name) const {
  for (const Wire& wire : wires()) {
    if (name == wire.name) return wire;
  }
  return {};
}

void Model::trace_open(const std::filesystem::path& path, std::uint64_t clock, std::span<const TraceSignal> signals) {
  const TraceRequest request{path.c_str(), clock, signals.data(), signals.size()};
  if (!api_->trace_open(state_, &request)) {
    throw std::runtime_error(path.string() + ": the model was built without waveforms");
  }
}

}  // namespace wrinkle
