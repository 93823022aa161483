// What a reader passed over or made up, for the user to know. Not errors.
#pragma once

#include <string>
#include <vector>

namespace wrinkle {

using Notes = std::vector<std::string>;

}  // namespace wrinkle
