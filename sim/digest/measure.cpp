#include "sim/digest/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "golden/vertex/scene.h"
#include "sim/digest/hashes.h"
#include "sim/input_error.h"
#include "sim/scene/scene_reader.h"
#include "tb/bench.h"
#include "tb/process.h"
#include "tb/random_frame.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRandom = "random:";
// Few enough for a model that was built in haste.
constexpr double kRandomFragments = 4000;

Frame frame_of(const Config& config, const std::string& scene) {
  if (!scene.starts_with(kRandom)) return build_frame(config, read_scene(scene));
  RandomFrame wish;
  wish.fragments = kRandomFragments;
  const char* const last = scene.data() + scene.size();
  const auto [end, error] = std::from_chars(scene.data() + kRandom.size(), last, wish.seed);
  if (error != std::errc() || end != last) throw InputError(Place{"digest"}, "\"" + scene + "\"", "random:SEED");
  return random_frame(config, wish);
}

struct Drawn {
  std::uint64_t fragments = 0;
  std::vector<std::string> hashes;
};

Drawn draw_golden(const Config& config, const Frame& frame, const PacketStream& stream) {
  Drawn drawn;
  StageHashes hashes(config);
  FragmentValues values;
  const auto take = [&](const auto& batch) {
    drawn.fragments += static_cast<std::uint64_t>(batch.count);
    for (int i = 0; i < batch.count; ++i) {
      extract(batch, i, values);
      hashes.add(fragment(batch, i), values);
    }
  };
  Golden(config, frame.textures).draw(stream.words, {take, take});
  drawn.hashes = hashes.texts();
  return drawn;
}

MeasuredFrame left_out(const DigestFrame& frame, const std::string& reason) {
  MeasuredFrame measured{{frame, std::vector<std::string>(measured_columns().size(), "-"), 0}, reason};
  measured.line.cells[2] = kLeftOut;
  return measured;
}

void add_files(Hash& hash, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    hash.add(fs::relative(file, folder).string() + '\0' + read_text(file) + '\0');
  }
}

}  // namespace

bool is_random(const DigestFrame& frame) { return frame.scene.starts_with(kRandom); }

MeasuredFrame measure(const DigestFrame& asked, const Engines& engines, bool optimize) {
  const Config config = config_of(asked.settings, "digest", 0);
  Frame frame;
  PacketStream stream;
  try {
    frame = frame_of(config, asked.scene);
    stream = build_packets(config, frame);
  } catch (const std::invalid_argument& refused) {
    return left_out(asked, refused.what());
  } catch (const std::range_error& refused) {
    return left_out(asked, refused.what());
  }
  const Drawn drawn = draw_golden(config, frame, stream);
  MeasuredFrame measured{{asked, {fmt::format("{}", drawn.fragments), "-", "-"}, 0}, ""};
  measured.line.cells.insert(measured.line.cells.end(), drawn.hashes.begin(), drawn.hashes.end());
  if (engines.golden_only) return measured;
  // Without stalls, so that the clocks are the design's own; texels come after 0 to 8 clocks, by one seed for all.
  BenchOptions options;
  options.model.source_root = engines.rtl;
  options.model.optimize = optimize;
  const BenchResult result = run_bench(config, stream, frame.textures, frame.name, options);
  if (result.first) measured.note = describe(*result.first);
  measured.line.cells[1] = fmt::format("{}", result.cycles);
  measured.line.cells[2] = result.equal() ? kRtlEqual : kRtlDifferent;
  return measured;
}

std::string source_key(const Engines& engines) {
  Hash hash;
  hash.add(read_text("/proc/self/exe"));
  const fs::path root = WRINKLE_SOURCE_DIR;
  add_files(hash, root / "sim" / "scenes");
  if (engines.golden_only) return "golden " + hash_text(hash.digest());
  add_files(hash, root / "tb" / "glue");
  add_files(hash, (engines.rtl.empty() ? root : engines.rtl) / "rtl");
  return hash_text(hash.digest());
}

}  // namespace wrinkle
