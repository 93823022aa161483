#include "tb/scoreboard.h"

namespace wrinkle {
namespace {

// Nobody wants the rest of the golden model's fragments.
struct Cancelled {};

template <class Int>
GoldenBlock to_block(const Batch<Int>& batch) {
  GoldenBlock block;
  const auto count = static_cast<std::size_t>(batch.count);
  block.fragments.resize(count);
  for (std::size_t i = 0; i < count; ++i) block.fragments[i] = fragment(batch, static_cast<int>(i));
  block.packets.assign(batch.packet.begin(), batch.packet.begin() + batch.count);
  return block;
}

}  // namespace

GoldenSource::GoldenSource(const sc_core::sc_module_name& name, sc_core::sc_event& start)
    : sc_module(name), start_(start) {
  SC_HAS_PROCESS(GoldenSource);
  SC_THREAD(thread);
  // The golden model keeps batches of every stage on the stack.
  set_stack_size(8 << 20);
}

void GoldenSource::thread() {
  for (;;) {
    wait(start_);
    try {
      if (run_->options->compare) draw();
    } catch (const Cancelled&) {
    } catch (...) {
      run_->error = std::current_exception();
    }
    fragments->close();
  }
}

void GoldenSource::draw() {
  Golden model(*run_->config, *run_->textures);
  const auto put = [this](const auto& batch) {
    if (!fragments->put(to_block(batch))) throw Cancelled{};
  };
  model.draw(run_->words, {put, put});
}

Scoreboard::Scoreboard(const sc_core::sc_module_name& name, sc_core::sc_event& start) : sc_module(name), start_(start) {
  SC_HAS_PROCESS(Scoreboard);
  SC_THREAD(thread);
}

void Scoreboard::thread() {
  for (;;) {
    wait(start_);
    if (!run_->options->compare) continue;
    expected_ = {};
    next_ = 0;
    compared_ = 0;
    for (FragmentBlock block; rtl->get(block);) compare(block);
    if (!run_->stopped) finish();
    golden->cancel();
  }
}

bool Scoreboard::next_golden() {
  while (next_ == expected_.fragments.size()) {
    next_ = 0;
    expected_ = {};
    if (!golden->get(expected_)) return false;
  }
  return true;
}

void Scoreboard::compare(FragmentBlock& block) {
  for (std::size_t i = 0; i < block.fragments.size();) {
    if (!next_golden()) {
      differ(block, i);
      run_->surplus = true;
      run_->mismatches += block.fragments.size() - i;
      compared_ += block.fragments.size() - i;
      return;
    }
    const std::size_t end = i + std::min(block.fragments.size() - i, expected_.fragments.size() - next_);
    for (; i < end; ++i, ++next_, ++compared_) {
      if (block.fragments[i] == expected_.fragments[next_]) [[likely]]
        continue;
      differ(block, i);
      ++run_->mismatches;
    }
  }
}

void Scoreboard::differ(FragmentBlock& block, std::size_t index) {
  if (run_->first && run_->first->fragment <= compared_) return;
  FirstDifference d;
  d.fragment = compared_;
  d.cycle = block.first_cycle + block.clocks[index];
  d.rtl = block.fragments[index];
  if (!block.values.empty()) d.rtl_values = block.values[index];
  if (next_ < expected_.fragments.size()) {
    d.golden = expected_.fragments[next_];
    d.packet = expected_.packets[next_];
  } else {
    d.kind = Difference::Kind::kExtra;
  }
  run_->differ(std::move(d));
}

// What the RTL has not drawn is missing. A hang is told apart, and learns here where it happened.
void Scoreboard::finish() {
  if (!next_golden()) return;
  FirstDifference d;
  d.kind = Difference::Kind::kMissing;
  d.fragment = compared_;
  d.cycle = run_->cycles;
  d.golden = expected_.fragments[next_];
  d.packet = expected_.packets[next_];
  if (run_->first && run_->first->fragment == compared_) {
    d.kind = run_->first->kind;
    run_->first = d;
  } else {
    run_->differ(d);
  }
  run_->mismatches += golden_left();
}

std::uint64_t Scoreboard::golden_left() {
  std::uint64_t left = 0;
  while (next_golden()) {
    left += expected_.fragments.size() - next_;
    next_ = expected_.fragments.size();
  }
  return left;
}

}  // namespace wrinkle
