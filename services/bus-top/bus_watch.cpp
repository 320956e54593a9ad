#include "services/bus-top/bus_watch.hpp"

namespace markservo::bus_top {

void BusWatch::observe(const std::string& channel, const reflection::MessageNote& note, const void* data, double now) {
  auto entry = channels_.find(channel);
  if (entry == channels_.end()) {
    if (channels_.size() >= kMaxChannels) {
      ++unwatched_;
      return;
    }
    entry = channels_.try_emplace(channel).first;
  }
  entry->second.watch.observe(note, now);
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  entry->second.newest.assign(bytes, bytes + note.bytes);
}

const BusWatch::Channel* BusWatch::find(const std::string& channel) const {
  const auto entry = channels_.find(channel);
  return entry == channels_.end() ? nullptr : &entry->second;
}

}  // namespace markservo::bus_top
