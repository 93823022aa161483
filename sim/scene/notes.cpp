#include "sim/scene/notes.h"

#include <algorithm>

namespace wrinkle {

void PassedOver::see(const std::string& what, const Place& place) {
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.what == what; });
  if (found != entries_.end()) {
    ++found->count;
  } else if (entries_.size() < 64) {  // a file of noise is told apart from a model by its first words
    entries_.push_back({what, place.text(), 1});
  }
}

void PassedOver::add_to(Notes& notes) const {
  for (const Entry& entry : entries_) {
    notes.push_back(entry.place + ": " + shortened(entry.what) +
                    (entry.count > 1 ? " (" + std::to_string(entry.count) + " times)" : ""));
  }
}

}  // namespace wrinkle
