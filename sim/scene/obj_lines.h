// Wavefront's two kinds of text files, OBJ and MTL, as lines of words.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/input_error.h"

namespace wrinkle {

struct ObjWord {
  std::string_view text;
  unsigned line = 0, column = 0;  // counted from 1
};

// One line, or several that a backslash at the end joins, without comments.
struct ObjLine {
  const std::string& file;
  std::string keyword;  // the first word in lower case
  std::vector<ObjWord> words;

  std::size_t values() const { return words.size() - 1; }
  Place place(std::size_t word) const { return {file, words[word].line, words[word].column, {}}; }
  std::string quoted(std::size_t word) const { return "\"" + shortened(std::string(words[word].text)) + "\""; }
  // Words `first` to `last`, with the white space between them as it is written; without quotes around the whole.
  std::string text(std::size_t first, std::size_t last) const;
  std::string rest(std::size_t first) const { return first < words.size() ? text(first, words.size() - 1) : ""; }
  // The number at `word`, finite and within the range; an error with its place otherwise.
  double number(std::size_t word, double minimum, double maximum) const;
};

// Every line that has a word, in order. Lines end with LF, CR LF or CR; a comment begins with # at the start of a word.
void for_each_obj_line(const std::string& file, std::string_view text,
                       const std::function<void(const ObjLine&)>& visit);

// Whether the whole of `text` is a number, and which.
bool parse_number(std::string_view text, double& value);

}  // namespace wrinkle
