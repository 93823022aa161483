// The tables of golden/config and golden/values.def as a page of the documents: docs/parameters.md.
#pragma once

#include <string>

namespace wrinkle {

// The whole file. It is checked in, so that it can be read where the repository is shown; a test makes it again.
std::string parameter_page();

}  // namespace wrinkle
