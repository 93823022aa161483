// All datapaths, and the one of a configuration.
#pragma once

#define WRINKLE_DATAPATH(name, Type)
#include "golden/datapath/list.def"
#undef WRINKLE_DATAPATH

namespace wrinkle {

// The values of the parameter `datapath`, kPhong and so on.
enum class Datapath {
#define WRINKLE_DATAPATH(name, Type) k##Type,
#include "golden/datapath/list.def"
#undef WRINKLE_DATAPATH
};

// visit(datapath) of every datapath for a configuration, in the order of the list.
template <class Visit>
void for_each_datapath(const Config& config, Visit&& visit) {
#define WRINKLE_DATAPATH(name, Type) visit(#name, Type(config));
#include "golden/datapath/list.def"
#undef WRINKLE_DATAPATH
}

// visit(datapath) of the one that the configuration has.
template <class Visit>
auto with_datapath(const Config& config, Visit&& visit) {
  switch (static_cast<Datapath>(config.datapath)) {
#define WRINKLE_DATAPATH(name, Type) \
  case Datapath::k##Type:            \
    return visit(Type(config));
#include "golden/datapath/list.def"
#undef WRINKLE_DATAPATH
  }
  throw std::logic_error("there is no such datapath");
}

}  // namespace wrinkle
