// The texture memory: a TLM-2.0 target of 64-bit words.
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <systemc>
#include <vector>

#include "tb/texel_store.h"

namespace wrinkle {

class TextureMemory : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<TextureMemory> socket;

  explicit TextureMemory(const sc_core::sc_module_name& name);

  void load(const std::vector<Texture>& textures, bool grant_direct_access);

  // What lies where; to read it is a transaction.
  const TexelStore& directory() const { return store_; }

 private:
  void transport(tlm::tlm_generic_payload& transaction, sc_core::sc_time& delay);
  bool direct_access(tlm::tlm_generic_payload& transaction, tlm::tlm_dmi& dmi);

  TexelStore store_;
  bool grant_direct_access_ = true;
};

}  // namespace wrinkle
