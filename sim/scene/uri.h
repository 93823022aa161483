// Names in glTF: URIs of files beside it, and URIs that hold the bytes themselves.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "sim/input_error.h"

namespace wrinkle {

bool is_data_uri(std::string_view uri);

struct DataUri {
  std::string media_type;  // in lower case, without parameters; empty where none is given
  std::string bytes;
};
// data:[media type][;parameter]...[;base64],bytes [RFC 2397]. Base64 of either alphabet, with or without padding.
DataUri decode_data_uri(std::string_view uri, const Place& place);

// %20 and the like replaced by the bytes that they stand for; a % without two digits stays, and so does a +.
std::string decode_percent(std::string_view text);

// The file that a URI in a file of `folder` names: decoded, or, since many exporters do not encode, as it stands, or
// without the query and fragment. Schemes other than a relative path are an error.
std::filesystem::path find_uri(const std::filesystem::path& folder, const std::string& uri, const Place& place);

}  // namespace wrinkle
