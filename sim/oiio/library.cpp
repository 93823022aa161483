#include "sim/oiio/library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace wrinkle::oiio {
namespace {

const Library& load() {
  void* module = dlopen(WRINKLE_OIIO_MODULE, RTLD_LAZY | RTLD_LOCAL);
  void* function = module != nullptr ? dlsym(module, "wrinkle_oiio_library") : nullptr;
  if (function == nullptr) throw std::runtime_error(std::string("OpenImageIO cannot be loaded: ") + dlerror());
  return *reinterpret_cast<const Library* (*)()>(function)();
}

}  // namespace

const Library& library() {
  static const Library& loaded = load();
  return loaded;
}

}  // namespace wrinkle::oiio
