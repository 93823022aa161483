#include "sim/scene/uri.h"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "sim/scene/files.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

// The six bits of a base64 digit, of either alphabet; -1 for what is none.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::string decode_base64(std::string_view text, const std::string& media_type, const Place& place) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  std::size_t digits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (std::isspace(static_cast<unsigned char>(text[i]))) continue;
    if (text[i] == '=') break;
    const int digit = base64_digit(text[i]);
    if (digit < 0) {
      throw InputError(place,
                       "a data URI of \"" + media_type + "\" whose character " + std::to_string(i) + " is no base64",
                       "digits A-Z, a-z, 0-9, + and /");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    if (++digits % 4 == 0) {
      for (int shift = 16; shift >= 0; shift -= 8) bytes += static_cast<char>(bits >> shift & 0xFF);
    }
  }
  if (digits % 4 == 1) {
    throw InputError(place, "a data URI of \"" + media_type + "\" that is cut short", "groups of four base64 digits");
  }
  if (digits % 4 == 2) bytes += static_cast<char>(bits >> 4 & 0xFF);
  if (digits % 4 == 3) bytes.append({static_cast<char>(bits >> 10 & 0xFF), static_cast<char>(bits >> 2 & 0xFF)});
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) { return lower_case(uri.substr(0, 5)) == "data:"; }

DataUri decode_data_uri(std::string_view uri, const Place& place) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) {
    throw InputError(place, "a data URI without a comma: \"" + std::string(uri.substr(0, 60)) + "\"",
                     "data:[media type][;base64],bytes");
  }
  const std::string header = lower_case(uri.substr(5, comma - 5));
  const std::string media_type = header.substr(0, header.find(';'));
  const std::string body = decode_percent(uri.substr(comma + 1));
  const bool base64 = header.ends_with(";base64");
  return {media_type, base64 ? decode_base64(body, media_type.substr(0, 60), place) : body};
}

std::string decode_percent(std::string_view text) {
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isxdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  const auto digit = [&](std::size_t i) {
    return text[i] <= '9' ? text[i] - '0' : 10 + (std::tolower(static_cast<unsigned char>(text[i])) - 'a');
  };
  std::string bytes;
  bytes.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped = text[i] == '%' && is_digit(i + 1) && is_digit(i + 2);
    bytes += escaped ? static_cast<char>(16 * digit(i + 1) + digit(i + 2)) : text[i];
    if (escaped) i += 2;
  }
  return bytes;
}

fs::path find_uri(const fs::path& folder, const std::string& uri, const Place& place) {
  const std::size_t colon = uri.find(':');
  if (colon != std::string::npos && colon < uri.find('/')) {
    throw InputError(place, "the URI \"" + uri.substr(0, 60) + "\"", "a path relative to the file");
  }
  const std::string decoded = decode_percent(uri);
  const std::string bare = decode_percent(uri.substr(0, uri.find_first_of("?#")));
  for (const std::string& name : {decoded, uri, bare}) {
    if (is_file(folder, name)) return find_file(folder, name, place);
  }
  return find_file(folder, decoded, place);  // which says that there is none
}

}  // namespace wrinkle
