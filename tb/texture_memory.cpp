#include "tb/texture_memory.h"

#include <cstring>

namespace wrinkle {

TextureMemory::TextureMemory(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {
  socket.register_b_transport(this, &TextureMemory::transport);
  socket.register_get_direct_mem_ptr(this, &TextureMemory::direct_access);
}

void TextureMemory::load(const std::vector<Texture>& textures, int texel_bits, bool grant_direct_access) {
  if (grant_direct_access_) socket->invalidate_direct_mem_ptr(0, ~sc_dt::uint64{0});
  grant_direct_access_ = grant_direct_access;
  words_.clear();
  levels_.clear();
  first_level_.assign(1, 0);
  const std::uint64_t mask = texel_bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << texel_bits) - 1;
  for (const Texture& texture : textures) {
    for (std::size_t level = 0; level < texture.levels.size(); ++level) {
      const int number = static_cast<int>(level);
      levels_.push_back({words_.size() * sizeof(std::uint64_t), static_cast<std::uint32_t>(texture.width(number)),
                         static_cast<std::uint32_t>(texture.height(number))});
      for (const std::uint64_t texel : texture.levels[level]) words_.push_back(texel & mask);
    }
    first_level_.push_back(levels_.size());
  }
}

void TextureMemory::transport(tlm::tlm_generic_payload& transaction, sc_core::sc_time&) {
  const std::uint64_t address = transaction.get_address();
  const std::uint64_t length = transaction.get_data_length();
  const std::uint64_t size = words_.size() * sizeof(std::uint64_t);
  if (transaction.get_command() != tlm::TLM_READ_COMMAND) {
    transaction.set_response_status(tlm::TLM_COMMAND_ERROR_RESPONSE);
    return;
  }
  if (address > size || length > size - address) {
    transaction.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return;
  }
  std::memcpy(transaction.get_data_ptr(), reinterpret_cast<const unsigned char*>(words_.data()) + address, length);
  transaction.set_dmi_allowed(grant_direct_access_);
  transaction.set_response_status(tlm::TLM_OK_RESPONSE);
}

bool TextureMemory::direct_access(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
  if (!grant_direct_access_ || words_.empty()) return false;
  dmi.set_dmi_ptr(reinterpret_cast<unsigned char*>(words_.data()));
  dmi.set_start_address(0);
  dmi.set_end_address(words_.size() * sizeof(std::uint64_t) - 1);
  dmi.allow_read();
  return true;
}

}  // namespace wrinkle
