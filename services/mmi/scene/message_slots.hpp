#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "common/reflection/type_catalog.hpp"

namespace markservo::mmi {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

// Which of the many that write on the channel a message is of: a stop device, "name@host", "host:folder"; empty of all
// else, and of what cannot be decoded.
std::string key_of(const reflection::TypeCatalog& types, const std::vector<std::uint8_t>& message);

// The newest message of each channel and key: `slots` of an update. Each message gets a version, which counts up, so
// that a reader asks for what is new since its last one. What was said longest ago goes first when there is too much.
class MessageSlots {
 public:
  struct Parameters {
    std::size_t slots_max = 1000;
    std::size_t channel_max = 100;       // of one channel: some twenty write on one
    std::size_t bytes_max = 64u << 20;   // of all messages: a robot's are 2 MB, pictures included
    std::size_t bytes_shown = 8u << 10;  // a longer array of bytes is told by its number
    std::size_t shown_max =
        256u << 10;  // bytes of what else a message holds, beyond which it is not shown: ours have 20 KB
  };

  class Slot {
   public:
    std::string channel;
    std::string key;
    std::int64_t at = 0;  // us, arrival
    std::uint64_t version = 0;
    Bytes bytes;

    // {"channel", "key", "at", "message" or "bad"} as JSON on one line; made at the first asking.
    const std::string& json() const;

   private:
    friend class MessageSlots;

    const reflection::TypeCatalog* types_ = nullptr;
    std::size_t bytes_shown_ = 0;
    std::size_t shown_max_ = 0;
    mutable std::string json_;
  };

  MessageSlots() : MessageSlots(Parameters{}) {}
  // `types` must outlive it.
  explicit MessageSlots(const Parameters& parameters,
                        const reflection::TypeCatalog& types = reflection::TypeCatalog::ours());

  // `channel` without a robot's prefix, any; `bytes` not null; `at`: us, arrival.
  const Slot& observe(const std::string& channel, Bytes bytes, std::int64_t at);

  // Of the newest message; 0: none yet.
  std::uint64_t version() const { return version_; }
  // What came after `version`, oldest first; 0: all. They hold until the next observe().
  std::vector<const Slot*> since(std::uint64_t version) const;
  // Null: nothing heard.
  const Slot* find(const std::string& channel, const std::string& key) const;

  std::size_t size() const { return by_version_.size(); }

 private:
  // Makes room for one more of `channel`.
  void make_room(const std::string& channel);
  void forget(std::map<std::uint64_t, Slot>::iterator slot);

  Parameters parameters_;
  const reflection::TypeCatalog* types_;
  std::map<std::uint64_t, Slot> by_version_;
  std::map<std::pair<std::string, std::string>, std::uint64_t> versions_;  // by channel and key
  std::size_t bytes_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace markservo::mmi
