// The texture memory: a TLM-2.0 target of 64-bit words, one texel each.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <systemc>
#include <vector>

#include "golden/texel/texture.h"

namespace wrinkle {

class TextureMemory : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<TextureMemory> socket;

  explicit TextureMemory(const sc_core::sc_module_name& name);

  // Where a level lies: byte address of its texel (0, 0), and its size.
  struct Level {
    std::uint64_t base;
    std::uint32_t width, height;
  };

  // Lays out the levels of all textures one after the other, rows in order; `texel_bits` are kept of each texel.
  void load(const std::vector<Texture>& textures, int texel_bits, bool grant_direct_access);

  // Null for a level that is not there.
  const Level* level(unsigned texture, unsigned level) const {
    if (texture >= first_level_.size() - 1) return nullptr;
    const std::size_t index = first_level_[texture] + level;
    return index < first_level_[texture + 1] ? &levels_[index] : nullptr;
  }

 private:
  void transport(tlm::tlm_generic_payload& transaction, sc_core::sc_time& delay);
  bool direct_access(tlm::tlm_generic_payload& transaction, tlm::tlm_dmi& dmi);

  std::vector<std::uint64_t> words_;
  std::vector<Level> levels_;
  std::vector<std::size_t> first_level_{0};  // per texture, and one past the last
  bool grant_direct_access_ = true;
};

}  // namespace wrinkle
