#include "tb/texture_memory.h"

#include <cstring>

namespace wrinkle {

TextureMemory::TextureMemory(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {
  socket.register_b_transport(this, &TextureMemory::transport);
  socket.register_get_direct_mem_ptr(this, &TextureMemory::direct_access);
}

void TextureMemory::load(const std::vector<Texture>& textures, bool grant_direct_access) {
  if (grant_direct_access_) socket->invalidate_direct_mem_ptr(0, ~sc_dt::uint64{0});
  grant_direct_access_ = grant_direct_access;
  store_.load(textures);
}

void TextureMemory::transport(tlm::tlm_generic_payload& transaction, sc_core::sc_time&) {
  const std::uint64_t address = transaction.get_address();
  const std::uint64_t length = transaction.get_data_length();
  const std::uint64_t size = store_.size();
  if (transaction.get_command() != tlm::TLM_READ_COMMAND) {
    transaction.set_response_status(tlm::TLM_COMMAND_ERROR_RESPONSE);
    return;
  }
  if (address > size || length > size - address) {
    transaction.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return;
  }
  std::memcpy(transaction.get_data_ptr(), store_.bytes() + address, length);
  transaction.set_dmi_allowed(grant_direct_access_);
  transaction.set_response_status(tlm::TLM_OK_RESPONSE);
}

bool TextureMemory::direct_access(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
  if (!grant_direct_access_ || store_.size() == 0) return false;
  dmi.set_dmi_ptr(store_.bytes());
  dmi.set_start_address(0);
  dmi.set_end_address(store_.size() - 1);
  dmi.allow_read();
  return true;
}

}  // namespace wrinkle
