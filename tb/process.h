// Running the tools that build a model.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace wrinkle {

using Arguments = std::vector<std::string>;

// A child process whose output, both streams, goes to a file.
class Process {
 public:
  // Starts `arguments[0]`, found on PATH. Throws std::runtime_error when it cannot be started.
  Process(const Arguments& arguments, const std::filesystem::path& log);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // Waits; the exit code, or 128 + the signal that ended it.
  int wait();

 private:
  int pid_ = -1;
};

// All of a file; empty when it cannot be read.
std::string read_text(const std::filesystem::path& path);

// The first line a tool prints for `arguments`; throws std::runtime_error when it does not run.
std::string first_line(const Arguments& arguments);

// Holds an exclusive lock on a file while it lives; the system releases it when the process ends.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace wrinkle
