#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "sim/input_error.h"
#include "sim/scene/files.h"
#include "sim/vectors/vectors.h"

namespace wrinkle {
namespace {

Place place(const std::filesystem::path& path, const VectorLine& line) { return {path.string(), line.number, 0, ""}; }

const std::string& word_at(const std::filesystem::path& path, const VectorLine& line, std::size_t word) {
  if (word >= line.words.size())
    throw InputError(place(path, line), fmt::format("{} words", line.words.size()),
                     fmt::format("at least {}", word + 1));
  return line.words[word];
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("+-0123456789") == std::string::npos;
}

VectorKind kind_of(const std::filesystem::path& path, const VectorLine& line) {
  const std::string& first = line.words.front();
  if (first == "T") return VectorKind::kCoverage;
  if (first == "M") return VectorKind::kTrilinear;
  if (is_number(first) && line.words.size() == 2) return VectorKind::kRsqrt;
  if (is_number(first) && (line.words.size() == 9 || (line.words.size() == 4 && line.words[3] == "undef")))
    return VectorKind::kNormalize;
  throw InputError(
      place(path, line), fmt::format("a line that begins with '{}'", first),
      "coverage (T), trilinear (M), normalize (three integers and six results) or rsqrt (two integers) vectors");
}

}  // namespace

std::string name(VectorKind kind) {
  switch (kind) {
    case VectorKind::kCoverage:
      return "coverage";
    case VectorKind::kTrilinear:
      return "trilinear";
    case VectorKind::kNormalize:
      return "normalize";
    case VectorKind::kRsqrt:
      break;
  }
  return "rsqrt";
}

std::vector<VectorLine> read_vector_lines(const std::filesystem::path& path, VectorKind& kind) {
  std::istringstream text(read_text_file(path));
  std::vector<VectorLine> lines;
  std::string line;
  for (unsigned number = 1; std::getline(text, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    VectorLine next{number, {}};
    for (std::string word; words >> word;) next.words.push_back(word);
    if (!next.words.empty()) lines.push_back(std::move(next));
  }
  if (lines.empty()) throw InputError(Place{path.string()}, "no vectors", "one a line");
  kind = kind_of(path, lines.front());
  return lines;
}

std::int64_t whole(const std::filesystem::path& path, const VectorLine& line, std::size_t word, int base) {
  const std::string& text = word_at(path, line, word);
  std::uint64_t bits = 0;
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  // Masks use all 64 bits.
  const auto result =
      base == 16 ? std::from_chars(text.data(), end, bits, 16) : std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end)
    throw InputError(place(path, line), fmt::format("'{}'", text), base == 16 ? "a hexadecimal number" : "an integer");
  return base == 16 ? std::int64_t(bits) : value;
}

double real(const std::filesystem::path& path, const VectorLine& line, std::size_t word) {
  const std::string& text = word_at(path, line, word);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
    throw InputError(place(path, line), fmt::format("'{}'", text), "a finite number");
  return value;
}

}  // namespace wrinkle
