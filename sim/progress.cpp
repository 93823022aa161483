#include "sim/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace wrinkle {

Progress::Progress(std::string label, std::uint64_t total)
    : label_(std::move(label)), total_(total), visible_(isatty(STDERR_FILENO) != 0) {
  at(0);
}

Progress::~Progress() { clear(); }

void Progress::clear() {
  if (visible_) fmt::print(stderr, "\r\033[K");
}

void Progress::at(std::uint64_t done, std::string_view note) {
  if (!visible_) return;
  const auto now = std::chrono::steady_clock::now();
  if (done != 0 && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const std::string amount =
      total_ == 0 ? fmt::format("{}", done) : fmt::format("{:3.0f} %", 100.0 * double(done) / double(total_));
  fmt::print(stderr, "\r\033[K{} {} {}", label_, amount, note);
  std::fflush(stderr);
}

}  // namespace wrinkle
