#include "services/mmi/world/world_reader.hpp"

#include <algorithm>
#include <markservo/channels.hpp>
#include <vector>

#include "common/reflection/message_json.hpp"
#include "common/reflection/message_note.hpp"
#include "common/reflection/type_catalog.hpp"
#include "common/watch/watch_json.hpp"
#include "services/mmi/pictures/picture_maker.hpp"
#include "services/mmi/troubles/state_json.hpp"

namespace markservo::mmi {
namespace {

// Makes `text` anew where its version is another than `version`.
template <class Make>
const VersionedText& renewed(VersionedText& text, std::uint64_t version, Make make) {
  if (text.version != version) text = {version, reflection::json_text(make(), -1)};
  return text;
}

}  // namespace

WorldReader::WorldReader(const robot::RobotDescription& robot, const std::string& tag_field,
                         const Parameters& parameters)
    : parameters_(parameters),
      arm_view_(robot),
      places_view_(robot),
      floor_view_(robot, tag_field),
      narrator_(robot, parameters.narrator) {}

void WorldReader::observe(const std::string& channel, const void* data, std::size_t size, std::int64_t at, double now) {
  const auto& types = reflection::TypeCatalog::ours();
  now_ = now;
  if (!began_) began_ = now;
  watch_.observe(channel, reflection::note_of(types, data, size), data, now);
  const auto* first = static_cast<const std::uint8_t*>(data);
  const auto bytes = std::make_shared<const std::vector<std::uint8_t>>(first, first + size);
  slots_.observe(channel, bytes, at);
  join_frame(channel, bytes, at, now);
  const ReadReport read = narrator_.observe(channel, data, size, at, now);
  if (!read.bad.empty()) refuse(channel, read.bad);
  arm_view_.observe(read.report);
  places_view_.observe(read.report);
  floor_view_.observe(read.report);
}

void WorldReader::refuse(const std::string& channel, const std::string& why) {
  if (watch_.find(channel) == nullptr) return;  // one of too many: BusWatch counts those
  Refused& refused = refused_[channel];
  ++refused.count;
  refused.why = why;
}

void WorldReader::join_frame(const std::string& channel, const Bytes& bytes, std::int64_t at, double now) {
  const bool is_frame = channel == channels::kStereoFrame.name;
  if (!is_frame && !FrameRing::is_answer(channel)) return;
  const auto message = reflection::decode(reflection::TypeCatalog::ours(), bytes->data(), bytes->size());
  if (!message.error.empty()) return;
  if (is_frame) {
    if (!is_picture(message.fields)) return;
    frames_.add(message.fields, bytes, at, now);
  } else {
    frames_.join(channel, message.fields, bytes, at);
  }
}

void WorldReader::advance(std::int64_t at, double now) {
  now_ = now;
  narrator_.advance(at, now);
  if (figures_made_ && now - *figures_made_ < parameters_.figures_every) return;
  figures_made_ = now;
  make_figures();
}

void WorldReader::make_figures() {
  auto figures = nlohmann::ordered_json::object();
  const nlohmann::ordered_json watched = watch::watch_json(watch_, heard_for(), now_);
  for (const auto& channel : watched["channels"]) {
    const auto name = channel["channel"].get<std::string>();
    auto& figure = figures[name];
    figure = channel;
    const auto refused = refused_.find(name);
    figure["refused"] = refused == refused_.end() ? 0 : refused->second.count;
    figure["refusal"] = refused == refused_.end() ? "" : refused->second.why;
  }
  figures_ = {figures_.version + 1, reflection::json_text(figures, -1)};
  latency_ = {latency_.version + 1, reflection::json_text(nlohmann::ordered_json(frames_.delays()), -1)};
}

const VersionedText& WorldReader::arm() {
  return renewed(arm_, arm_view_.version(), [this] { return arm_view_.json(); });
}

const VersionedText& WorldReader::places() {
  return renewed(places_, places_view_.version(), [this] { return places_view_.json(); });
}

const VersionedText& WorldReader::floor() {
  return renewed(floor_, floor_view_.version(), [this] { return floor_view_.json(); });
}

const VersionedText& WorldReader::trouble_list() {
  return renewed(trouble_list_, narrator_.version(), [this] { return troubles_json(narrator_.troubles()); });
}

}  // namespace markservo::mmi
