// What a reader passed over or made up, for the user to know. Not errors.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "sim/input_error.h"

namespace wrinkle {

using Notes = std::vector<std::string>;

// What may be met many times and is noted once: where it was first, and how often.
class PassedOver {
 public:
  void see(const std::string& what, const Place& place);
  void add_to(Notes& notes) const;

 private:
  struct Entry {
    std::string what, place;
    std::size_t count = 0;
  };
  std::vector<Entry> entries_;
};

}  // namespace wrinkle
