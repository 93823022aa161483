#include "tb/tap_recorder.h"

namespace wrinkle {

std::int64_t unpack(const Value& value, TapWire wire, int element) {
  const std::uint64_t sign = std::uint64_t{1} << (value.width - 1);
  const std::uint64_t bits = static_cast<std::uint64_t>(wire >> (element * value.width)) & (sign | (sign - 1));
  return static_cast<std::int64_t>(value.is_signed ? (bits ^ sign) - sign : bits);
}

TapRecorder::TapRecorder(const Config& config) : values_(values(config)) {
  for (int stage = 0; stage < kStages; ++stage) {
    const auto s = static_cast<std::size_t>(stage);
    range_[s] = {kValues, 0};
    for (int i = 0; i < kValues; ++i) {
      if (values_[static_cast<std::size_t>(i)].stage != kStageNames[stage]) continue;
      range_[s] = {std::min(range_[s].first, i), i + 1};
    }
  }
}

void TapRecorder::sample(const Taps& taps, std::uint64_t (&transfers)[kStages]) {
  for (std::uint32_t moving = taps.stages & taps.valid & taps.ready; moving != 0; moving &= moving - 1) {
    const auto stage = static_cast<std::size_t>(__builtin_ctz(moving));
    const std::uint64_t fragment = transfers[stage]++;
    if (fragment < taken_) continue;  // a broken stage may lag behind the fragments
    while (fragment - taken_ >= rows_.size()) rows_.emplace_back(values_.size());
    FragmentValues& row = rows_[fragment - taken_];
    for (int i = range_[stage].first; i < range_[stage].second; ++i) {
      const auto index = static_cast<std::size_t>(i);
      const Value& value = values_[index];
      if (!value.present) continue;
      for (int element = 0; element < value.elements; ++element) {
        row[index][static_cast<std::size_t>(element)] = unpack(value, taps.values[i], element);
      }
    }
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
