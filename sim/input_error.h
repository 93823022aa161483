// The one error of bad input: thrown by every reader, caught in main, exit code 2.
#pragma once

#include <stdexcept>
#include <string>

namespace wrinkle {

// Where something was found: a file, and in it a line and column (0 = not known) or a place such as /accessors/3/count.
struct Place {
  std::string file;
  unsigned line = 0, column = 0;
  std::string inner;

  std::string text() const {
    std::string t = file;
    if (line > 0) t.append(":").append(std::to_string(line));
    if (line > 0 && column > 0) t.append(":").append(std::to_string(column));
    if (!inner.empty()) t.append(": ").append(inner);
    return t;
  }
};

// What a file holds may be megabytes on one line, or hold control characters: at most 400 bytes of it are shown.
inline std::string shortened(std::string text) {
  constexpr std::size_t kLongest = 400;
  if (text.size() > kLongest) {
    const std::string size = std::to_string(text.size());
    std::size_t end = kLongest - 60;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // never within a UTF-8 character
    text = text.substr(0, end) + "... (" + size + " bytes in all)";
  }
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return text;
}

class InputError : public std::runtime_error {
 public:
  // "scene.toml:12:7: found X, expected Y".
  InputError(const Place& place, const std::string& found, const std::string& expected)
      : std::runtime_error(place.text() + ": found " + shortened(found) + ", expected " + expected) {}
  // For what has no expectation of its own: "scene.toml:12:7: message".
  InputError(const Place& place, const std::string& message) : std::runtime_error(place.text() + ": " + message) {}
};

}  // namespace wrinkle
