#pragma once

#include <cstddef>

#include "common/bus_watch/channel_watch.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::bus_watch {

// What the `size` bytes at `data`, any bytes, tell by the types of `catalog`.
MessageNote note_of(const reflection::TypeCatalog& catalog, const void* data, std::size_t size);

}  // namespace markservo::bus_watch
