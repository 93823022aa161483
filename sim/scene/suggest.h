// Names for messages: "did you mean".
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle {

// "; did you mean \"name\"?" for the candidate nearest to `word`, or nothing where none is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

// `a, b or c`, each in double quotes.
std::string list_of(std::span<const std::string_view> words);

}  // namespace wrinkle
