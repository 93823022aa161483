#include "sim/scene/suggest.h"

#include <algorithm>

#include "sim/oiio/library.h"

namespace wrinkle {

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
  word = word.substr(0, 64);  // nothing longer is near any name, and the distance is quadratic
  std::size_t best = std::max<std::size_t>(2, word.size() / 3) + 1;
  std::string_view nearest;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = oiio::library().edit_distance(word, candidate);
    if (distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  return nearest.empty() ? "" : "; did you mean \"" + std::string(nearest) + "\"?";
}

std::string list_of(std::span<const std::string_view> words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += "\"" + std::string(words[i]) + "\"";
  }
  return text;
}

}  // namespace wrinkle
