#include "sim/scene/files.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <system_error>

namespace wrinkle {

namespace fs = std::filesystem;

void check_file(const fs::path& path, const Place& place, std::uintmax_t limit) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw InputError(place, "no file \"" + path.string() + "\"", "a file that exists");
  if (fs::is_directory(status)) throw InputError(place, "the folder \"" + path.string() + "\"", "a file");
  if (!fs::is_regular_file(status)) throw InputError(place, "\"" + path.string() + "\"", "a regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw InputError(place, "\"" + path.string() + "\"", "a readable file");
  if (size == 0) throw InputError(place, "the empty file \"" + path.string() + "\"", "at least one byte");
  if (size > limit) {
    throw InputError(place, "\"" + path.string() + "\" of " + std::to_string(size) + " bytes",
                     "at most " + std::to_string(limit));
  }
}

std::string read_file(const fs::path& path, std::uintmax_t limit) {
  const Place place{path.string(), 0, 0, {}};
  check_file(path, place, limit);
  std::ifstream stream(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(fs::file_size(path)), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream) throw InputError(place, "a file that cannot be read", "a readable file");
  return text;
}

fs::path find_file(const fs::path& folder, const std::string& name, const Place& place) {
  if (name.empty()) throw InputError(place, "an empty file name", "a file");
  fs::path path = folder / fs::path(name);
  std::error_code error;
  if (!fs::exists(path, error) && name.find('\\') != std::string::npos) {
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    path = folder / fs::path(slashes);
  }
  check_file(path, place);
  return path;
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace wrinkle
