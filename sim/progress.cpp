#include "sim/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace wrinkle {

Progress::Progress(std::string label, std::uint64_t total)
    : label_(std::move(label)),
      total_(total),
      last_(std::chrono::steady_clock::now()),
      terminal_(isatty(STDERR_FILENO) != 0) {
  if (terminal_) at(0);
}

Progress::~Progress() { clear(); }

void Progress::clear() {
  if (terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::at(std::uint64_t done, std::string_view note) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::milliseconds pause(terminal_ ? 100 : 10000);
  if (!(terminal_ && done == 0) && now - last_ < pause) return;
  last_ = now;
  const std::string amount =
      total_ == 0 ? fmt::format("{}", done) : fmt::format("{:3.0f} %", 100.0 * double(done) / double(total_));
  fmt::print(stderr, "{}{} {} {}{}", terminal_ ? "\r\033[K" : "", label_, amount, note, terminal_ ? "" : "\n");
  std::fflush(stderr);
}

}  // namespace wrinkle
