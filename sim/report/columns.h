// The values of a picture's pixels beside its colours, small enough to be part of a page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"
#include "sim/engine.h"

namespace wrinkle {

// A value x is the code (x - kColumnOffset) / kColumnStep in 16 bits; where nothing is drawn the code is 0.
inline constexpr double kColumnOffset = -4, kColumnStep = 1.0 / 8192;

// The picture that an engine draws, as {png, columns: [{values: [names of at most three], high, low}]}: the bytes of
// the codes are the red, green and blue of two more pictures. All are data URIs of PNG.
nlohmann::json picture_with_columns(Engine engine, const Config& config, const Frame& frame);

std::string data_uri(const Picture& picture);

}  // namespace wrinkle
