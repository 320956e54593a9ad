#include "common/watch/bus_watch.hpp"

namespace markservo::watch {

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
  if (keeps_ == Keeps::kFigures) return;
  const auto* bytes = static_cast<const std::uint8_t*>(data);
  entry->second.newest.assign(bytes, bytes + note.bytes);
}

const BusWatch::Channel* BusWatch::find(const std::string& channel) const {
  const auto entry = channels_.find(channel);
  return entry == channels_.end() ? nullptr : &entry->second;
}

std::vector<std::string> BusWatch::matching(const std::string& text, const ChannelPattern& pattern) const {
  if (find(text) != nullptr) return {text};
  std::vector<std::string> names;
  for (const auto& entry : channels_) {
    if (pattern.matches(entry.first)) names.push_back(entry.first);
  }
  return names;
}

}  // namespace markservo::watch
