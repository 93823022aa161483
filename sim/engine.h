// All engines behind one call: packets and textures in, fragments out.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "golden/config/config.h"
#include "golden/triangle/draw.h"
#include "sim/aov.h"
#include "sim/framebuffer.h"

namespace wrinkle {

enum class Engine { kIdeal, kExact, kGolden, kGoldenScalar, kRtl };

// "ideal", "exact", "golden", "golden-scalar", "rtl"; throws InputError for anything else.
Engine engine_named(const std::string& name);
std::string_view engine_names();

struct EngineRun {
  std::uint64_t fragments = 0;
  std::uint64_t cycles = 0;  // of the RTL, else 0
};

// Draws the frame. Every fragment goes to `sink`, in order of the packets, before any depth test.
EngineRun draw(Engine engine, const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs,
               const std::function<void(const Sample&)>& sink);

// A framebuffer that fits the frame and the configuration.
Framebuffer framebuffer_for(const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs = {});

// The frame as a picture, with the intermediates asked for.
Framebuffer drawn(Engine engine, const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs = {});

// Colour codes and z of a hardware fragment as real numbers.
Sample to_sample(const Shape& config, const Fragment& fragment, std::uint32_t triangle);

}  // namespace wrinkle
