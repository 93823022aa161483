#include "sim/scene/obj_lines.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

// Adds the words of one line of the file; true where the next line goes on with it.
bool add_words(std::string_view line, unsigned number, std::vector<ObjWord>& words) {
  for (std::size_t at = 0; at < line.size();) {
    if (is_space(line[at])) {
      ++at;
      continue;
    }
    if (line[at] == '#') return false;
    std::size_t end = at;
    while (end < line.size() && !is_space(line[end])) ++end;
    const bool last = line.find_first_not_of(" \t\v\f", end) == std::string_view::npos;
    const bool goes_on = last && line[end - 1] == '\\';
    const std::string_view word = line.substr(at, end - at - (goes_on ? 1 : 0));
    if (!word.empty()) words.push_back({word, number, static_cast<unsigned>(at) + 1});
    if (goes_on) return true;
    at = end;
  }
  return false;
}

}  // namespace

std::string ObjLine::text(std::size_t first, std::size_t last) const {
  std::string joined;
  for (std::size_t i = first; i <= last; ++i) {
    if (i > first) {
      const std::string_view before = words[i - 1].text;
      const char* gap = before.data() + before.size();
      joined += words[i].line == words[i - 1].line ? std::string(gap, words[i].text.data()) : " ";
    }
    joined += words[i].text;
  }
  const bool quoted = joined.size() > 2 && joined.front() == '"' && joined.back() == '"';
  return quoted ? joined.substr(1, joined.size() - 2) : joined;
}

bool parse_number(std::string_view text, double& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && !text.empty();
}

double ObjLine::number(std::size_t word, double minimum, double maximum) const {
  std::string_view text = words[word].text;
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    throw InputError(place(word), quoted(word), "a number that double precision holds");
  }
  if (error != std::errc() || end != text.data() + text.size()) throw InputError(place(word), quoted(word), "a number");
  return checked_number(value, minimum, maximum, std::string(words[0].text), place(word));
}

void for_each_obj_line(const std::string& file, std::string_view text,
                       const std::function<void(const ObjLine&)>& visit) {
  ObjLine line{file, {}, {}};
  unsigned number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    const bool goes_on = add_words(text.substr(at, end - at), ++number, line.words);
    at = end + (text.substr(end, 2) == "\r\n" ? 2 : 1);
    if ((goes_on && at < text.size()) || line.words.empty()) continue;
    line.keyword = line.words[0].text.substr(0, 64);
    for (char& c : line.keyword) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    visit(line);
    line.words.clear();
  }
}

}  // namespace wrinkle
