#include "services/rfid-localizer/tag_map.hpp"

#include <stdexcept>

namespace markservo::rfid_localizer {

TagMap::TagMap(const robot::TagField& field, double reach) : places_(reach) {
  if (field.tags.empty())
    throw std::invalid_argument("tag field '" + field.name + "' is empty; allowed: 1 tag or more");
  for (const robot::FloorTag& tag : field.tags) {
    by_uid_.emplace(tag.uid, static_cast<int>(size()));
    places_.add(tag.p_W);
  }
}

std::optional<int> TagMap::find(const std::string& uid) const {
  const auto entry = by_uid_.find(uid);
  if (entry == by_uid_.end()) return std::nullopt;
  return entry->second;
}

}  // namespace markservo::rfid_localizer
