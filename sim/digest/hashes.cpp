#include "sim/digest/hashes.h"

#include <xxhash.h>

#include <algorithm>
#include <bit>
#include <new>
#include <utility>

#include "golden/stages.h"
#include "sim/digest/table.h"

namespace wrinkle {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are hashed with their lowest byte first");

constexpr std::size_t kBlock = 1024;

XXH3_state_t* state_of(void* state) { return static_cast<XXH3_state_t*>(state); }

int stage_number(std::string_view name) {
  return static_cast<int>(std::find(std::begin(kStageNames), std::end(kStageNames), name) - std::begin(kStageNames));
}

}  // namespace

Hash::Hash() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_64bits_reset(state_of(state_));
}
Hash::~Hash() { XXH3_freeState(state_of(state_)); }
Hash::Hash(Hash&& other) noexcept : state_(std::exchange(other.state_, nullptr)), waiting_(std::move(other.waiting_)) {}
Hash& Hash::operator=(Hash&& other) noexcept {
  std::swap(state_, other.state_);
  std::swap(waiting_, other.waiting_);
  return *this;
}

void Hash::add(std::int64_t number) {
  waiting_.push_back(number);
  if (waiting_.size() == kBlock) flush();
}

void Hash::add(std::string_view text) {
  flush();
  XXH3_64bits_update(state_of(state_), text.data(), text.size());
}

void Hash::flush() {
  XXH3_64bits_update(state_of(state_), waiting_.data(), waiting_.size() * sizeof(std::int64_t));
  waiting_.clear();
}

std::uint64_t Hash::digest() {
  flush();
  return XXH3_64bits_digest(state_of(state_));
}

StageHashes::StageHashes(const Config& config) {
  const std::vector<Value> all = values(config);
  for (std::size_t v = 0; v < all.size(); ++v) {
    for (std::size_t e = 0; e < static_cast<std::size_t>(all[v].elements); ++e)
      columns_.push_back({v, e, stage_number(all[v].stage), {}});
  }
}

void StageHashes::add(const Fragment& f, const FragmentValues& values) {
  for (const std::int64_t number :
       {std::int64_t{f.x}, std::int64_t{f.y}, std::int64_t{f.z}, std::int64_t{f.colour[0]}, std::int64_t{f.colour[1]},
        std::int64_t{f.colour[2]}, std::int64_t{f.last}, std::int64_t{f.zero}})
    fragments_.add(number);
  for (Column& column : columns_) column.hash.add(values[column.value][column.element]);
}

std::vector<std::string> StageHashes::texts() {
  std::vector<std::string> texts{hash_text(fragments_.digest())};
  for (int stage = static_cast<int>(Stage::scan); stage < kStages; ++stage) {
    Hash whole;
    bool any = false;
    for (Column& column : columns_) {
      if (column.stage != stage) continue;
      any = true;
      whole.add(static_cast<std::int64_t>(column.hash.digest()));
    }
    texts.push_back(any ? hash_text(whole.digest()) : "-");
  }
  return texts;
}

}  // namespace wrinkle
