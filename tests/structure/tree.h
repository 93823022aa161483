// What the tests of structure read of a source tree.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

namespace wrinkle {

namespace fs = std::filesystem;

// Sentences that say what is missing or wrong, and where; none in a right tree.
using Faults = std::vector<std::string>;

// Empty where the file is absent.
inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The files below a folder whose names end in one of `endings`, sorted.
inline std::vector<fs::path> files_below(const fs::path& folder, const std::vector<std::string>& endings) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const bool wanted = std::find(endings.begin(), endings.end(), entry.path().extension()) != endings.end();
    if (entry.is_regular_file() && wanted) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// C++ and Verilog have the same comments.
inline std::string without_comments(const std::string& code) {
  static const std::regex comment("//[^\n]*|/\\*[^]*?\\*/");
  return std::regex_replace(code, comment, "");
}

// Every match of the first group of `pattern`, in order.
inline std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) found.push_back((*it)[1]);
  return found;
}

// The headings of a page, without the marks before them.
inline std::vector<std::string> headings(const fs::path& page) { return matches(text_of(page), "(?:^|\n)#+ ([^\n]*)"); }

inline bool contains(const std::vector<std::string>& list, const std::string& what) {
  return std::find(list.begin(), list.end(), what) != list.end();
}

}  // namespace wrinkle
