#include "sim/scene/files.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace wrinkle {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

namespace {

// Files by device and number: a link, or another spelling of the path, is the same file.
using FileId = std::pair<dev_t, ino_t>;

struct ReadFiles {
  std::mutex mutex;
  std::set<FileId> ids;
};
ReadFiles& read_files() {
  static ReadFiles files;
  return files;
}

bool id_of(const fs::path& path, FileId& id) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return false;
  id = {status.st_dev, status.st_ino};
  return true;
}

void remember_read(const fs::path& path) {
  FileId id;
  if (!id_of(path, id)) return;
  const std::lock_guard lock(read_files().mutex);
  read_files().ids.insert(id);
}

// `name` in `folder`, with slashes for backslashes where only that exists.
fs::path path_of(const fs::path& folder, const std::string& name) {
  const fs::path path = folder / fs::path(name);
  std::error_code error;
  if (fs::exists(path, error) || name.find('\\') == std::string::npos) return path;
  std::string slashes = name;
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  return folder / fs::path(slashes);
}

}  // namespace

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
  remember_read(path);
  return text;
}

std::string read_text_file(const fs::path& path, std::uintmax_t limit) {
  std::string text = read_file(path, limit);
  if (text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv)) {
    throw InputError(Place{path.string(), 1, 0, {}}, "text in UTF-16", "UTF-8: save the file anew in that encoding");
  }
  if (text.starts_with("\xef\xbb\xbf"sv)) text.erase(0, 3);
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) {
    const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n');
    throw InputError(Place{path.string(), static_cast<unsigned>(lines) + 1, 0, {}}, "a zero byte", "text");
  }
  return text;
}

void check_not_read(const fs::path& path) {
  FileId id;
  if (!id_of(path, id)) return;
  const std::lock_guard lock(read_files().mutex);
  if (!read_files().ids.contains(id)) return;
  throw InputError(Place{path.string()}, "a file that was read, which would be written over",
                   "another name for what is written");
}

bool is_file(const fs::path& folder, const std::string& name) {
  std::error_code error;
  return !name.empty() && name.find('\0') == std::string::npos && fs::is_regular_file(path_of(folder, name), error);
}

fs::path find_file(const fs::path& folder, const std::string& name, const Place& place) {
  if (name.empty() || name.find('\0') != std::string::npos) {
    throw InputError(place, name.empty() ? "an empty file name" : "a file name with a zero byte", "a file");
  }
  fs::path path = path_of(folder, name);
  check_file(path, place);
  return path;
}

std::string extension_of(const fs::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace wrinkle
