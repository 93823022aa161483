// Pictures in memory, on disk, and compared.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace wrinkle {

// Row-major, top row first, channels interleaved.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<float> data;

  Picture() = default;
  Picture(int w, int h, std::vector<std::string> names)
      : width(w), height(h), channels(std::move(names)), data(std::size_t(w) * std::size_t(h) * channels.size()) {}
};

// Writes by the ending of the name: .exr as float with named channels, all else as 8 bits clamped to [0, 1].
// The file appears whole or not at all. Throws InputError when it cannot be written.
void write_picture(const std::filesystem::path& path, const Picture& image);
// The bytes of the PNG file that write_picture would write.
std::string encode_png(const Picture& image);
// Writes a text file, which appears whole or not at all.
void write_text(const std::filesystem::path& path, const std::string& text);

// PSNR of equal pictures: a number, so that reports can be sorted.
inline constexpr double kPsnrOfEqual = 200;

struct PictureDifference {
  double psnr_db = kPsnrOfEqual;  // peak 1
  double max_error = 0;
  std::uint64_t pixels = 0;     // compared
  std::uint64_t different = 0;  // pixels with any difference
};
// Over the pixels that `mask` marks (one number a pixel).
PictureDifference compare(const Picture& a, const Picture& b, const std::vector<std::uint8_t>& mask);

// 0.5 + gain * (a - b), so that both signs are seen.
Picture difference_picture(const Picture& a, const Picture& b, double gain);

}  // namespace wrinkle
