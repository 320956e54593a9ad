#include "services/mmi/scene/message_slots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <variant>

#include "common/reflection/message_json.hpp"
#include "common/reflection/message_value.hpp"

namespace markservo::mmi {
namespace {

// The types of which many write on one channel, and the two fields that tell them apart.
struct Keyed {
  const char* type;
  const char* first;
  const char* between;
  const char* second;  // empty: the first alone
};
constexpr std::array kKeyed = {Keyed{"StopState", "device", "", ""}, Keyed{"ServiceStatus", "name", "@", "host"},
                               Keyed{"ProcessStatus", "name", "@", "host"},
                               Keyed{"RecorderStatus", "host", ":", "folder"}};

std::string text_in(const reflection::Fields& fields, const char* name) {
  const reflection::Value* value = fields.find(name);
  const auto* text = value == nullptr ? nullptr : std::get_if<std::string>(&value->content);
  return text == nullptr ? "" : *text;
}

// Bytes of all but arrays of bytes, roughly as many as in JSON.
std::size_t size_of(const reflection::Fields& fields);

struct SizeOf {
  std::size_t operator()(const std::string& text) const { return text.size(); }
  std::size_t operator()(const reflection::Bytes& /*shown by their number*/) const { return 0; }
  std::size_t operator()(const reflection::Fields& fields) const { return size_of(fields); }
  std::size_t operator()(const reflection::List& list) const {
    std::size_t size = 0;
    for (const reflection::Value& value : list) size += std::visit(*this, value.content);
    return size;
  }
  template <class Number>
  std::size_t operator()(const Number& /*number*/) const {
    return sizeof(Number);
  }
};

std::size_t size_of(const reflection::Fields& fields) {
  std::size_t size = 0;
  for (const reflection::Value& value : fields.values) size += std::visit(SizeOf{}, value.content);
  return size;
}

}  // namespace

std::string key_of(const reflection::TypeCatalog& types, const std::vector<std::uint8_t>& message) {
  std::uint64_t fingerprint = 0;
  if (!reflection::read_fingerprint(message.data(), message.size(), &fingerprint)) return {};
  const reflection::MessageType* type = types.find(fingerprint);
  if (type == nullptr) return {};
  for (const Keyed& keyed : kKeyed) {
    if (type->name != keyed.type) continue;
    const reflection::DecodedMessage decoded = reflection::decode(types, message.data(), message.size());
    if (!decoded.error.empty()) return {};
    return text_in(decoded.fields, keyed.first) + keyed.between + text_in(decoded.fields, keyed.second);
  }
  return {};
}

const std::string& MessageSlots::Slot::json() const {
  if (!json_.empty()) return json_;
  nlohmann::ordered_json json = {{"channel", channel}, {"key", key}, {"at", std::to_string(at)}};
  const reflection::DecodedMessage decoded = reflection::decode(*types_, bytes->data(), bytes->size());
  const std::size_t shown = decoded.error.empty() ? size_of(decoded.fields) : 0;
  if (shown > shown_max_) {
    json["bad"] = fmt::format("{} bytes of texts and numbers; up to {} are shown", shown, shown_max_);
  } else if (decoded.error.empty()) {
    json["message"] = reflection::json_of(decoded.fields, reflection::JsonForm::kExact, bytes_shown_);
  } else {
    json["bad"] = decoded.error;
  }
  json_ = reflection::json_text(json, -1);
  json_.pop_back();  // the end of the line
  return json_;
}

MessageSlots::MessageSlots(const Parameters& parameters, const reflection::TypeCatalog& types)
    : parameters_(parameters), types_(&types) {}

const MessageSlots::Slot& MessageSlots::observe(const std::string& channel, Bytes bytes, std::int64_t at) {
  std::string key = key_of(*types_, *bytes);
  if (const auto known = versions_.find({channel, key}); known != versions_.end()) {
    forget(by_version_.find(known->second));
  }
  make_room(channel);
  Slot slot;
  slot.channel = channel;
  slot.key = key;
  slot.at = at;
  slot.version = ++version_;
  slot.bytes = std::move(bytes);
  slot.types_ = types_;
  slot.bytes_shown_ = parameters_.bytes_shown;
  slot.shown_max_ = parameters_.shown_max;
  bytes_ += slot.bytes->size();
  while (!by_version_.empty() && (by_version_.size() >= parameters_.slots_max || bytes_ > parameters_.bytes_max)) {
    forget(by_version_.begin());
  }
  versions_.emplace(std::pair(channel, std::move(key)), version_);
  return by_version_.emplace_hint(by_version_.end(), version_, std::move(slot))->second;
}

std::vector<const MessageSlots::Slot*> MessageSlots::since(std::uint64_t version) const {
  std::vector<const Slot*> newer;
  for (auto slot = by_version_.upper_bound(version); slot != by_version_.end(); ++slot) newer.push_back(&slot->second);
  return newer;
}

const MessageSlots::Slot* MessageSlots::find(const std::string& channel, const std::string& key) const {
  const auto known = versions_.find({channel, key});
  return known == versions_.end() ? nullptr : &by_version_.at(known->second);
}

void MessageSlots::make_room(const std::string& channel) {
  std::size_t number = 0;
  std::uint64_t oldest = version_;
  for (auto known = versions_.lower_bound({channel, ""}); known != versions_.end(); ++known) {
    if (known->first.first != channel) break;
    ++number;
    oldest = std::min(oldest, known->second);
  }
  if (number >= parameters_.channel_max) forget(by_version_.find(oldest));
}

void MessageSlots::forget(std::map<std::uint64_t, Slot>::iterator slot) {
  bytes_ -= slot->second.bytes->size();
  versions_.erase({slot->second.channel, slot->second.key});
  by_version_.erase(slot);
}

}  // namespace markservo::mmi
