#include "sim/engine.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "golden/exact/exact.h"
#include "golden/pixel/pixel.h"
#include "sim/command.h"
#include "sim/input_error.h"
#include "tb/bench.h"

namespace wrinkle {
namespace {

using SampleSink = std::function<void(const Sample&)>;

EngineRun draw_float(Engine engine, const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs,
                     const SampleSink& sink) {
  EngineRun run;
  std::vector<double> numbers(aovs.size());
  const auto hand_on = [&](const ExactFragment& fragment) {
    ++run.fragments;
    for (std::size_t i = 0; i < aovs.size(); ++i)
      numbers[i] = aovs[i].exact ? aovs[i].exact(fragment, aovs[i].exact_element) : fragment.triangle + 1.0;
    sink({fragment.x,
          fragment.y,
          fragment.z,
          {fragment.colour.x, fragment.colour.y, fragment.colour.z},
          fragment.triangle,
          numbers});
  };
  (engine == Engine::kIdeal ? draw_ideal : draw_exact)(config, frame, hand_on);
  return run;
}

double number(const AovChannel& aov, const FragmentValues& values, std::uint32_t triangle) {
  if (aov.value < 0) return triangle + 1.0;
  const double value = aov.scale * double(values[std::size_t(aov.value)][aov.element]);
  return aov.factor < 0 ? value : value * double(values[std::size_t(aov.factor)][aov.factor_element]);
}

void fill(const std::vector<AovChannel>& aovs, const FragmentValues& values, std::uint32_t triangle,
          std::vector<double>& numbers) {
  for (std::size_t i = 0; i < aovs.size(); ++i) numbers[i] = number(aovs[i], values, triangle);
}

EngineRun draw_golden(Lanes lanes, const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs,
                      const SampleSink& sink) {
  EngineRun run;
  const PacketStream stream = build_packets(config, frame);
  std::vector<double> numbers(aovs.size());
  FragmentValues values;
  const auto hand_on = [&](const auto& batch) {
    run.fragments += std::uint64_t(batch.count);
    for (int i = 0; i < batch.count; ++i) {
      const std::uint32_t triangle = stream.packet_triangle[batch.packet[std::size_t(i)]];
      if (!aovs.empty()) {
        extract(batch, i, values);
        fill(aovs, values, triangle, numbers);
      }
      Sample sample = to_sample(config, fragment(batch, i), triangle);
      sample.aov = numbers;
      sink(sample);
    }
  };
  Golden(config, frame.textures, lanes).draw(stream.words, {hand_on, hand_on});
  return run;
}

// The RTL is drawn here and not verified: the picture is what it put out, right or wrong.
EngineRun draw_rtl(const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs,
                   const SampleSink& sink) {
  const PacketStream stream = build_packets(config, frame);
  std::vector<double> numbers(aovs.size());
  std::size_t packet = 0;
  const auto hand_on = [&](const Fragment& fragment) {
    if (packet >= stream.packet_triangle.size())
      throw std::runtime_error("the RTL drew more packets than it was given");
    Sample sample = to_sample(config, fragment, stream.packet_triangle[packet]);
    sample.aov = numbers;
    sink(sample);
    packet += fragment.last;
  };
  BenchSinks sinks;
  if (aovs.empty()) {
    sinks.fragments = [&](std::span<const Fragment> fragments) {
      for (const Fragment& fragment : fragments) hand_on(fragment);
    };
  } else {
    sinks.values = [&](const Fragment& fragment, const FragmentValues& values) {
      if (packet < stream.packet_triangle.size()) fill(aovs, values, stream.packet_triangle[packet], numbers);
      hand_on(fragment);
    };
  }
  BenchOptions options = quiet_bench_options();
  options.compare = false;
  const BenchResult result = run_bench(config, stream, frame.textures, frame.name, options, sinks);
  return {result.fragments, result.cycles};
}

}  // namespace

std::string_view engine_names() { return "ideal, exact, golden, golden-scalar, rtl"; }

Engine engine_named(const std::string& name) {
  if (name == "ideal") return Engine::kIdeal;
  if (name == "exact") return Engine::kExact;
  if (name == "golden") return Engine::kGolden;
  if (name == "golden-scalar") return Engine::kGoldenScalar;
  if (name == "rtl") return Engine::kRtl;
  throw InputError(Place{"--engine"}, name, fmt::format("one of {}", engine_names()));
}

Sample to_sample(const Shape& config, const Fragment& fragment, std::uint32_t triangle) {
  Sample sample{fragment.x, fragment.y, std::ldexp(double(fragment.z), -config.depth_bits), {}, triangle, {}};
  const double one = (1 << config.colour_bits) - 1;
  for (std::size_t c = 0; c < 3; ++c) sample.colour[c] = fragment.colour[config.count == 1 ? 0 : c] / one;
  return sample;
}

EngineRun draw(Engine engine, const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs,
               const SampleSink& sink) {
  switch (engine) {
    case Engine::kIdeal:
    case Engine::kExact:
      return draw_float(engine, config, frame, aovs, sink);
    case Engine::kGolden:
      return draw_golden(Lanes::kSimd, config, frame, aovs, sink);
    case Engine::kGoldenScalar:
      return draw_golden(Lanes::kScalar, config, frame, aovs, sink);
    case Engine::kRtl:
      break;
  }
  return draw_rtl(config, frame, aovs, sink);
}

Framebuffer framebuffer_for(const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs) {
  std::vector<std::string> names;
  for (const AovChannel& channel : aovs) names.push_back(channel.name);
  return Framebuffer(frame.width, frame.height, frame.background, config.depth != 0, std::move(names));
}

Framebuffer drawn(Engine engine, const Config& config, const Frame& frame, const std::vector<AovChannel>& aovs) {
  Framebuffer framebuffer = framebuffer_for(config, frame, aovs);
  draw(engine, config, frame, aovs, [&](const Sample& sample) { framebuffer.add(sample); });
  return framebuffer;
}

}  // namespace wrinkle
