#include "tb/tap_recorder.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace wrinkle {
namespace {

Wire find(std::span<const Wire> wires, std::string_view name) {
  const auto found = std::find_if(wires.begin(), wires.end(), [&](const Wire& wire) { return name == wire.name; });
  return found == wires.end() ? Wire{} : *found;
}

// Up to 64 bits of a wire from bit `low` on; what lies beyond its memory is 0.
std::uint64_t bits_from(const Wire& wire, std::size_t low) {
  const std::size_t byte = low / 8, shift = low % 8;
  if (byte >= wire.bytes) return 0;
  std::uint64_t bits = 0;
  std::memcpy(&bits, wire.data + byte, std::min(sizeof bits, wire.bytes - byte));
  bits >>= shift;
  if (shift != 0 && byte + 8 < wire.bytes) bits |= std::uint64_t{wire.data[byte + 8]} << (64 - shift);
  return bits;
}

}  // namespace

std::int64_t unpack(const Value& value, const Wire& wire, int element) {
  const std::uint64_t sign = std::uint64_t{1} << (value.width - 1);
  const std::uint64_t bits =
      bits_from(wire, static_cast<std::size_t>(value.lowest_bit + element * value.width)) & (sign | (sign - 1));
  return static_cast<std::int64_t>(value.is_signed ? (bits ^ sign) - sign : bits);
}

TapRecorder::TapRecorder(std::vector<Value> values, const PerStage<int>& moves, std::span<const Wire> wires)
    : values_(std::move(values)), moves_(moves) {
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
    const std::string name(kStageNames[stage]);
    StageWires& found = wires_[stage];
    found.valid = find(wires, name + "_valid");
    found.ready = find(wires, name + "_ready");
    seen_[stage].visible = moves_[stage] > 0 && found.valid.data != nullptr && found.ready.data != nullptr;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      if (values_[i].stage != name) continue;
      const Wire wire = find(wires, values_[i].wire);
      if (wire.data != nullptr) found.taps.push_back({i, wire});
    }
  }
}

std::vector<bool> TapRecorder::visible_values() const {
  std::vector<bool> visible(values_.size());
  for (const StageWires& stage : wires_) {
    for (const Tap& tap : stage.taps) visible[tap.value] = true;
  }
  return visible;
}

void TapRecorder::sample() {
  for (std::size_t stage = 0; stage < kStageNames.size(); ++stage) {
    if (!seen_[stage].visible) continue;
    seen_[stage].valid = *wires_[stage].valid.data != 0;
    if (seen_[stage].valid && *wires_[stage].ready.data != 0) record(stage, seen_[stage].transfers++);
  }
}

void TapRecorder::record(std::size_t stage, std::uint64_t transfer) {
  const auto moves = static_cast<std::uint64_t>(moves_[stage]);
  const std::uint64_t fragment = transfer / moves;
  if (fragment < taken_) return;  // a broken stage may lag behind the fragments
  while (fragment - taken_ >= rows_.size()) rows_.emplace_back(values_.size());
  FragmentValues& row = rows_[fragment - taken_];
  for (const auto& [index, wire] : wires_[stage].taps) {
    const Value& value = values_[index];
    const auto first = static_cast<std::size_t>(transfer % moves) * static_cast<std::size_t>(value.elements);
    for (int element = 0; element < value.elements; ++element)
      row[index][first + static_cast<std::size_t>(element)] = unpack(value, wire, element);
  }
}

FragmentValues TapRecorder::take() {
  ++taken_;
  if (rows_.empty()) return FragmentValues(values_.size());
  FragmentValues row = std::move(rows_.front());
  rows_.pop_front();
  return row;
}

}  // namespace wrinkle
