#include "services/mmi/server/client_word.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace markservo::mmi {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string& key, const std::string& allowed) {
  throw std::invalid_argument("'" + key + "' is missing or wrong; allowed: " + allowed);
}

const Json& member(const Json& message, const char* key, const std::string& allowed) {
  const auto found = message.find(key);
  if (found == message.end()) refuse(key, allowed);
  return *found;
}

std::string text_at(const Json& message, const char* key) {
  const auto found = message.find(key);
  if (found == message.end() || found->is_null()) return {};
  if (!found->is_string() || found->get_ref<const std::string&>().size() > kLongestText) {
    refuse(key, "a text of up to " + std::to_string(kLongestText) + " bytes");
  }
  return found->get<std::string>();
}

// A number, or, beyond JavaScript's 53 bits, a text of one.
std::int64_t integer_at(const Json& message, const char* key) {
  static const std::string allowed = "a whole number, or a text of one";
  const Json& value = member(message, key, allowed);
  if (value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX)) {
    refuse(key, allowed);
  }
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (!value.is_string()) refuse(key, allowed);
  const auto& text = value.get_ref<const std::string&>();
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) refuse(key, allowed);
  return number;
}

ClientWord hello(const Json& message) {
  if (integer_at(message, "protocol") != kProtocol) {
    throw std::invalid_argument("another protocol than " + std::to_string(kProtocol) + ": reload the page");
  }
  return ClientHello{text_at(message, "token")};
}

bool flag_at(const Json& message, const char* key) {
  const Json& flag = member(message, key, "true or false");
  if (!flag.is_boolean()) refuse(key, "true or false");
  return flag.get<bool>();
}

ClientWord lease(const Json& message) {
  return ClientLease{flag_at(message, "on"), message.count("take") != 0 && flag_at(message, "take")};
}

geometry::PlanePose place_at(const Json& message) {
  static const std::string allowed = "[x, y, heading], m and rad";
  const Json& place = member(message, "place", allowed);
  if (!place.is_array() || place.size() != 3) refuse("place", allowed);
  double numbers[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!place[i].is_number()) refuse("place", allowed);
    numbers[i] = place[i].get<double>();
    if (!(std::abs(numbers[i]) <= kFarthest)) refuse("place", "numbers up to 10,000");
  }
  return {numbers[0], numbers[1], numbers[2]};
}

ClientWord command(const Json& message) {
  static const std::map<std::string, task::Action> actions{
      {"start", task::Action::kStart}, {"carry", task::Action::kStart}, {"abort", task::Action::kAbort},
      {"home", task::Action::kHome},   {"drive", task::Action::kDrive}, {"reset", task::Action::kReset}};
  const std::string kind = text_at(message, "kind");
  const auto action = actions.find(kind);
  if (action == actions.end()) refuse("kind", "start, carry, abort, home, drive, reset");
  ClientCommand command;
  command.stamp = {integer_at(message, "session"), integer_at(message, "seq"), integer_at(message, "expires")};
  command.command.action = action->second;
  command.command.carry = kind == "carry";
  if (action->second == task::Action::kStart) command.command.target = text_at(message, "target");
  if (action->second == task::Action::kDrive) command.command.place = place_at(message);
  return command;
}

ClientWord pictures(const Json& message) {
  return ClientPictures{flag_at(message, "on")};
}

ClientWord look(const Json& message) {
  static const std::string allowed = "up to " + std::to_string(kMostLooked) + " channels' names";
  const Json& channels = member(message, "channels", allowed);
  if (!channels.is_array() || channels.size() > kMostLooked) refuse("channels", allowed);
  ClientLook look;
  for (const Json& channel : channels) {
    if (!channel.is_string() || channel.get_ref<const std::string&>().size() > kLongestText) {
      refuse("channels", allowed);
    }
    look.channels.push_back(channel.get<std::string>());
  }
  return look;
}

ClientWord play(const Json& message) {
  static const std::string allowed = "above 0, up to " + std::to_string(static_cast<int>(kFastestPlay));
  const Json& speed = member(message, "speed", allowed);
  if (!speed.is_number()) refuse("speed", allowed);
  const double value = speed.get<double>();
  if (!(value > 0.0) || value > kFastestPlay) refuse("speed", allowed);
  return ClientPlay{value};
}

ClientWord step(const Json& message) {
  const std::int64_t by = integer_at(message, "by");
  if (by != 1 && by != -1) refuse("by", "1 or -1");
  return ClientStep{static_cast<int>(by)};
}

}  // namespace

ClientWord parse_client_word(std::string_view text) {
  const Json message = Json::parse(text, nullptr, false);
  if (!message.is_object()) throw std::invalid_argument("no JSON object; allowed: {\"type\": ...}");
  const std::string type = text_at(message, "type");
  if (type == "hello") return hello(message);
  if (type == "pictures") return pictures(message);
  if (type == "seen") return ClientSeen{integer_at(message, "number")};
  if (type == "took") return ClientTook{integer_at(message, "number")};
  if (type == "look") return look(message);
  if (type == "stop") return ClientStop{text_at(message, "reason")};
  if (type == "play") return play(message);
  if (type == "pause") return ClientPause{};
  if (type == "seek") return ClientSeek{integer_at(message, "utime")};
  if (type == "step") return step(message);
  if (type == "lease") return lease(message);
  if (type == "command") return command(message);
  refuse("type", "hello, pictures, seen, took, look, stop, play, pause, seek, step, lease, command");
}

}  // namespace markservo::mmi
