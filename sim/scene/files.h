// Files as a reader wants them: regular, readable, not larger than it is ready to hold.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/input_error.h"

namespace wrinkle {

inline constexpr std::uintmax_t kMaximumFileBytes = std::uintmax_t{1} << 30;

// Throws unless `path` is a regular file of 1 to `limit` bytes (symbolic links are followed). `place` is who names it.
void check_file(const std::filesystem::path& path, const Place& place, std::uintmax_t limit = kMaximumFileBytes);
// The whole file, after check_file(); remembered as one that was read.
std::string read_file(const std::filesystem::path& path, std::uintmax_t limit = kMaximumFileBytes);
// A file of text: the same without its UTF-8 byte order mark. UTF-16 and zero bytes are an error.
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t limit = kMaximumFileBytes);

// Throws when `path` is, under whatever name, a file that this program has read.
void check_not_read(const std::filesystem::path& path);

// Whether find_file() would find one.
bool is_file(const std::filesystem::path& folder, const std::string& name);
// The file that `name`, written in a file of `folder`, stands for: relative to `folder`, with backslashes read as
// slashes where no file has them in its name. Throws, naming `place`, when there is none.
std::filesystem::path find_file(const std::filesystem::path& folder, const std::string& name, const Place& place);
// Lower-case extension with its dot.
std::string extension_of(const std::filesystem::path& path);

}  // namespace wrinkle
