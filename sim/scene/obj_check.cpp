#include "sim/scene/obj_check.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "sim/input_error.h"
#include "sim/scene/defaults.h"
#include "sim/scene/toml_table.h"

namespace wrinkle {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

// One line as words with their columns.
struct Line {
  const std::string& file;
  unsigned number = 0;
  std::vector<std::string_view> words;
  const char* start = nullptr;

  Place place(std::size_t word) const {
    return {file, number, static_cast<unsigned>(words[word].data() - start) + 1, {}};
  }
  std::string quoted(std::size_t word) const { return "\"" + std::string(words[word].substr(0, 40)) + "\""; }
};

template <typename Visitor>
void for_each_line(const std::string& file, std::string_view text, const Visitor& visit) {
  Line line{file, 0, {}, nullptr};
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view rest = text.substr(at, end - at);
    at = end + 1;
    ++line.number;
    line.start = rest.data();
    line.words.clear();
    while (true) {
      while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
      if (rest.empty() || (line.words.empty() && rest.front() == '#')) break;
      const auto stop = std::find_if(rest.begin(), rest.end(), is_space);
      line.words.push_back(rest.substr(0, static_cast<std::size_t>(stop - rest.begin())));
      rest.remove_prefix(line.words.back().size());
    }
    if (!line.words.empty()) visit(line);
  }
}

double number_at(const Line& line, std::size_t word, double minimum, double maximum) {
  std::string_view text = line.words[word];
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) {
    throw InputError(line.place(word), line.quoted(word), "a number that double precision holds");
  }
  if (error != std::errc() || end != text.data() + text.size()) {
    throw InputError(line.place(word), line.quoted(word), "a number");
  }
  return checked_number(value, minimum, maximum, std::string(line.words[0]), line.place(word));
}

// Between `least` and `most` numbers after the keyword.
void check_numbers(const Line& line, std::size_t least, std::size_t most) {
  const std::size_t count = line.words.size() - 1;
  if (count < least || count > most) {
    const std::string range =
        least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
    throw InputError(line.place(0), std::string(line.words[0]) + " with " + std::to_string(count) + " numbers", range);
  }
  for (std::size_t i = 1; i <= count; ++i) number_at(line, i, -kMaximumCoordinate, kMaximumCoordinate);
}

// Corners are checked against what is known at the end of the file: a face may come before its vertices.
struct LargestReference {
  std::size_t index = 0;
  Place place;
  void see(std::size_t i, const Place& p) {
    if (i <= index) return;
    index = i;
    place = p;
  }
  void check(std::size_t size, const char* what) const {
    if (index <= size) return;
    throw InputError(place, "index " + std::to_string(index),
                     "at most " + std::to_string(size) + ", the number of " + what);
  }
};

class ObjChecker {
 public:
  void operator()(const Line& line) {
    const std::string_view keyword = line.words[0];
    if (keyword == "v") {
      check_numbers(line, 3, 7);  // with weight or colour
      ++counts_.positions;
    } else if (keyword == "vt") {
      check_numbers(line, 1, 3);
      ++counts_.uvs;
    } else if (keyword == "vn") {
      check_numbers(line, 3, 3);
      ++counts_.normals;
    } else if (keyword == "f") {
      check_face(line);
    }
  }

  ObjCounts finish() const {
    largest_[0].check(counts_.positions, "positions (v)");
    largest_[1].check(counts_.uvs, "texture coordinates (vt)");
    largest_[2].check(counts_.normals, "normals (vn)");
    return counts_;
  }

 private:
  void check_face(const Line& line) {
    if (line.words.size() < 4) {
      throw InputError(line.place(0), "a face of " + std::to_string(line.words.size() - 1) + " corners", "at least 3");
    }
    for (std::size_t i = 1; i < line.words.size(); ++i) check_corner(line, i);
    counts_.triangles += line.words.size() - 3;
    if (counts_.triangles > kMaximumTriangles) {
      throw InputError(line.place(0), "more than " + std::to_string(kMaximumTriangles) + " triangles", "fewer");
    }
  }

  // position, position/uv, position//normal or position/uv/normal; each counted from 1, or from the end when negative.
  void check_corner(const Line& line, std::size_t word) {
    const std::array<std::size_t, 3> sizes{counts_.positions, counts_.uvs, counts_.normals};
    std::string_view rest = line.words[word];
    for (std::size_t part = 0; part < 3; ++part) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      const std::string_view text = rest.substr(0, slash);
      if (!text.empty()) check_index(line, word, text, sizes[part], largest_[part]);
      if (text.empty() && (part == 0 || slash == rest.size())) break;
      if (slash == rest.size()) return;
      rest.remove_prefix(slash + 1);
    }
    throw InputError(line.place(word), line.quoted(word), "a corner v, v/vt, v//vn or v/vt/vn");
  }

  static void check_index(const Line& line, std::size_t word, std::string_view text, std::size_t size,
                          LargestReference& largest) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (error != std::errc() || end != text.data() + text.size() || index == 0) {
      throw InputError(line.place(word), line.quoted(word), "a corner of indices counted from 1");
    }
    if (index < 0 && static_cast<std::uint64_t>(-(index + 1)) >= size) {
      throw InputError(line.place(word), "index " + std::to_string(index), "at least -" + std::to_string(size));
    }
    if (index > 0) largest.see(static_cast<std::size_t>(index), line.place(word));
  }

  ObjCounts counts_;
  std::array<LargestReference, 3> largest_;
};

void check_mtl_line(const Line& line) {
  const std::string_view keyword = line.words[0];
  if (keyword == "Ka" || keyword == "Kd" || keyword == "Ks") {
    if (line.words.size() == 4) {
      for (std::size_t i = 1; i < 4; ++i) number_at(line, i, 0, 1e6);
    } else {
      throw InputError(line.place(0),
                       std::string(keyword) + " with " + std::to_string(line.words.size() - 1) + " words", "3 numbers");
    }
  } else if (keyword == "Ns") {
    if (line.words.size() != 2) throw InputError(line.place(0), "Ns without one number", "a number");
    number_at(line, 1, 0, 1e6);
  }
  for (std::size_t i = 1; i < line.words.size(); ++i) {
    if (line.words[i] != "-bm") continue;
    if (i + 1 == line.words.size()) throw InputError(line.place(i), "-bm at the end of the line", "-bm and a number");
    number_at(line, i + 1, -1e4, 1e4);
  }
}

}  // namespace

ObjCounts check_obj(const std::string& file, std::string_view text) {
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos) {
    const auto line =
        static_cast<unsigned>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n'));
    throw InputError(Place{file, line + 1, 0, {}}, "a zero byte", "text");
  }
  ObjChecker checker;
  for_each_line(file, text, [&](const Line& line) { checker(line); });
  return checker.finish();
}

void check_mtl(const std::string& file, std::string_view text) { for_each_line(file, text, check_mtl_line); }

std::vector<std::string> material_libraries(std::string_view text) {
  std::vector<std::string> names;
  const std::string file;
  for_each_line(file, text, [&](const Line& line) {
    if (line.words[0] != "mtllib" || line.words.size() < 2) return;
    const char* first = line.words[1].data();
    const char* last = line.words.back().data() + line.words.back().size();
    names.emplace_back(first, last);  // one name, white space and all
  });
  return names;
}

}  // namespace wrinkle
