// Hashes of what golden hands on: of its fragments, and of the values of each stage.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "golden/pixel/pixel.h"

namespace wrinkle {

// XXH3, 64 bits, of what is added one after the other: numbers as eight bytes each, the lowest first.
class Hash {
 public:
  Hash();
  ~Hash();
  Hash(Hash&&) noexcept;
  Hash& operator=(Hash&&) noexcept;

  void add(std::int64_t number);
  void add(std::string_view text);
  std::uint64_t digest();

 private:
  void flush();

  void* state_;
  std::vector<std::int64_t> waiting_;
};

// Every element of every value that a configuration has is a column with a hash of its own, over all fragments. The
// hash of a stage is that over the hashes of its columns, in pipeline order: neither the names of values nor the size
// of golden's batches matter.
class StageHashes {
 public:
  explicit StageHashes(const Config& config);

  void add(const Fragment& fragment, const FragmentValues& values);
  // Of the fragments, and of each stage in turn; "-" for a stage without values.
  std::vector<std::string> texts();

 private:
  struct Column {
    std::size_t value, element;
    int stage;
    Hash hash;
  };
  Hash fragments_;
  std::vector<Column> columns_;
};

}  // namespace wrinkle
