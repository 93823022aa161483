// Progress on standard error: a line that is redrawn where that is a terminal, else a new line every ten seconds.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace wrinkle {

class Progress {
 public:
  // `total` in any unit; 0 when it is not known.
  Progress(std::string label, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // May be called often: on a terminal the line is redrawn at most ten times a second.
  void at(std::uint64_t done, std::string_view note = "");
  // Removes the line, so that something else can be printed.
  void clear();

 private:
  std::string label_;
  std::uint64_t total_;
  std::chrono::steady_clock::time_point last_;
  bool terminal_;
};

}  // namespace wrinkle
