// The waveform around a difference: its clock is the message's, and the values stand in it as the message gives them.
#include <gtest/gtest.h>
#include <gtkwave/fstapi.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>

#include "tb/bench.h"
#include "tb/process.h"
#include "tb/random_frame.h"
#include "tests/bench/configurations.h"

namespace wrinkle {
namespace {

namespace fs = std::filesystem;

fs::path scratch() {
  const fs::path folder = fs::path(testing::TempDir()) / ("wrinkle_waveform_" + std::to_string(getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

// The signals of an FST file, by name, each with the values it takes by time.
class Fst {
 public:
  using Values = std::map<std::uint64_t, std::string>;

  explicit Fst(const fs::path& path) : reader_(fstReaderOpen(path.c_str())) {
    if (reader_ == nullptr) return;
    while (fstHier* entry = fstReaderIterateHier(reader_)) {
      if (entry->htyp == FST_HT_SCOPE) scopes_.push_back(scope() + entry->u.scope.name + ".");
      if (entry->htyp == FST_HT_UPSCOPE) scopes_.pop_back();
      if (entry->htyp == FST_HT_VAR) add(entry->u.var);
    }
    fstReaderSetFacProcessMaskAll(reader_);
    fstReaderIterBlocks(
        reader_,
        [](void* self, std::uint64_t time, fstHandle handle, const unsigned char* value) {
          static_cast<Fst*>(self)->values_[handle][time] = reinterpret_cast<const char*>(value);
        },
        this, nullptr);
  }
  ~Fst() {
    if (reader_ != nullptr) fstReaderClose(reader_);
  }

  bool has(const std::string& name) const { return handles_.contains(name); }
  // What a signal is at a time: a number as it is, an integer from its bits.
  double at(const std::string& name, std::uint64_t time) const {
    const fstHandle handle = handles_.at(name);
    const Values& values = values_.at(handle);
    auto next = values.upper_bound(time);
    if (next == values.begin()) return -1;
    const std::string& text = (--next)->second;
    if (!reals_.at(handle)) return static_cast<double>(std::strtoull(text.c_str(), nullptr, 2));
    return std::strtod(text.c_str(), nullptr);
  }

 private:
  std::string scope() const { return scopes_.empty() ? "" : scopes_.back(); }
  void add(const auto& var) {
    std::string name = scope() + var.name;
    name.resize(std::min(name.size(), name.find(' ')));
    name.resize(std::min(name.size(), name.find('[')));
    handles_[name] = var.handle;
    reals_[var.handle] = var.typ == FST_VT_VCD_REAL;
  }

  void* reader_;
  std::vector<std::string> scopes_;
  std::map<std::string, fstHandle> handles_;
  std::map<fstHandle, bool> reals_;
  std::map<fstHandle, Values> values_;
};

class Waveforms : public testing::Test {
 protected:
  void SetUp() override {
    root_ = scratch();
    fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "rtl", root_ / "rtl", fs::copy_options::recursive);
  }
  void TearDown() override { fs::remove_all(root_); }
  void plant(const std::string& stage, const std::string& from, const std::string& to) const {
    const fs::path file = root_ / "rtl" / "stage" / ("wrinkle_" + stage + ".v");
    std::string text = read_text(file);
    ASSERT_NE(text.find(from), text.npos);
    text.replace(text.find(from), from.size(), to);
    std::ofstream(file) << text;
  }
  Difference first_difference() const {
    RandomFrame wish;
    wish.seed = 25;
    wish.fragments = 2000;
    wish.draws = 3;
    BenchOptions options;
    options.model = {root_, root_ / "cache", false, false};
    options.trace = root_ / "difference.fst";
    const BenchResult result = run_bench(small_config(), random_frame(small_config(), wish), options);
    return result.first.value_or(Difference{});
  }

  fs::path root_;
};

constexpr std::uint64_t kClock = 1000;  // in the file's unit

TEST_F(Waveforms, ShowTheDifferenceAtTheClockOfTheMessage) {
  plant("output", ".data_i(colour)", ".data_i(colour ^ (carried[3:0] == 9))");
  const Difference d = first_difference();
  ASSERT_EQ(d.stage, "output");
  ASSERT_EQ(d.trace, root_ / "difference.fst");
  const Fst file(d.trace);
  const std::uint64_t time = kClock * d.trace_cycle;
  ASSERT_TRUE(file.has("bench.clock"));
  EXPECT_EQ(file.at("bench.clock", time), static_cast<double>(d.trace_cycle));
  EXPECT_EQ(file.at("TOP.clk", time), 1);
  EXPECT_EQ(file.at("TOP.clk", time + kClock / 2), 0);
  EXPECT_EQ(file.at("bench.output.differs", time), 1);
  EXPECT_EQ(file.at("bench.output.transfer", time), 1);
  EXPECT_EQ(file.at("TOP.wrinkle_core.output_valid", time), 1);
  EXPECT_EQ(file.at("TOP.wrinkle_core.output_ready", time), 1);
  const std::string value = "bench.output." + d.value + (file.has("bench.output." + d.value + "_x_rtl") ? "_x" : "");
  EXPECT_EQ(file.at(value + "_golden", time), d.golden_real());
  EXPECT_EQ(file.at(value + "_rtl", time), d.rtl_real());
  for (std::uint64_t clock = d.trace_cycle - 20; clock < d.trace_cycle; ++clock) {
    EXPECT_EQ(file.at("bench.output.differs", kClock * clock), 0) << clock;
    EXPECT_EQ(file.at("bench.light.differs", kClock * clock), 0) << clock;
    EXPECT_EQ(file.at("bench.clock", kClock * clock + kClock - 1), static_cast<double>(clock));
  }
}

// Both viewers are given names that the file has, and the clock of the message.
TEST_F(Waveforms, ViewsNameSignalsOfTheFile) {
  plant("output", ".data_i(colour)", ".data_i(colour ^ (carried[3:0] == 9))");
  const Difference d = first_difference();
  const Fst file(d.trace);
  int signals = 0;
  std::ifstream surfer(root_ / "difference.sucl"), gtkwave(root_ / "difference.gtkw");
  std::string all;
  for (std::string line; std::getline(surfer, line); all += line + "\n") {
    if (!line.starts_with("variable_add ")) continue;
    EXPECT_TRUE(file.has(line.substr(13))) << line;
    ++signals;
  }
  EXPECT_NE(all.find("cursor_set " + std::to_string(d.trace_cycle) + "ns"), all.npos);
  std::string marker;
  for (std::string line; std::getline(gtkwave, line);) {
    if (line.starts_with("*-")) marker = line.substr(line.rfind(' ') + 1);
    if (!line.starts_with("bench.") && !line.starts_with("TOP.")) continue;
    EXPECT_TRUE(file.has(line.substr(0, line.find('[')))) << line;
    --signals;
  }
  EXPECT_EQ(marker, std::to_string(kClock * d.trace_cycle));
  EXPECT_EQ(signals, 0) << "both name the same signals";
}

}  // namespace
}  // namespace wrinkle
