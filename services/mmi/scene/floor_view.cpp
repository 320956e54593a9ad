#include "services/mmi/scene/floor_view.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "services/mmi/scene/vector_json.hpp"

namespace markservo::mmi {

FloorView::FloorView(const robot::RobotDescription& robot, const std::string& tag_field, const Parameters& parameters)
    : parameters_(parameters), reader_(robot.rfid), poses_(parameters.history) {
  if (robot.floor_tags) tags_ = robot.floor_tags->field(tag_field).tags;
  for (const robot::FloorTag& tag : tags_) places_.emplace(tag.uid, tag.p_W);
}

void FloorView::observe(const Report& report) {
  if (const auto* pose = std::get_if<PoseReport>(&report)) {
    poses_.add(*pose);
  } else if (const auto* round = std::get_if<RoundReport>(&report)) {
    observe_round(*round);
  }
}

void FloorView::observe_round(const RoundReport& report) {
  Round round;
  round.utime = report.utime;
  std::unordered_set<std::string> seen;
  for (const TagHit& hit : report.hits) {
    if (seen.insert(hit.uid).second) round.read.push_back({hit, count(hit.uid)});
  }
  judge(round);
  newest_ = std::move(round);
  ++version_;
}

std::int64_t FloorView::count(const std::string& uid) {
  const auto known = counts_.find(uid);
  if (known != counts_.end()) return ++known->second;
  if (counts_.size() < parameters_.tags_max) counts_.emplace(uid, 1);
  return 1;
}

void FloorView::judge(Round& round) const {
  std::unordered_set<std::string> read;
  for (const Read& tag : round.read) read.insert(tag.hit.uid);
  std::optional<Eigen::Vector2d> p_WF;
  if (reader_) {
    const double delay = poses_.delay().value_or(reader_->delay);
    round.X_WR = poses_.at(std::max<std::int64_t>(round.utime, 0) - std::llround(1e6 * delay));
    if (round.X_WR) p_WF = *round.X_WR * reader_->p_RF;
  }
  if (p_WF) {
    for (const robot::FloorTag& tag : tags_) {
      if ((tag.p_W - *p_WF).norm() > reader_->reading_radius) continue;
      round.expected.push_back(tag.uid);
      if (read.count(tag.uid) == 0) round.missed.push_back(tag.uid);
    }
  }
  for (const Read& tag : round.read) {
    const auto place = places_.find(tag.hit.uid);
    const bool far = place != places_.end() && p_WF &&
                     (place->second - *p_WF).norm() >
                         reader_->reading_radius + parameters_.surprise_softnesses * reader_->edge_softness;
    if (place == places_.end() || far) round.unexpected.push_back(tag.hit.uid);
  }
}

nlohmann::ordered_json FloorView::json() const {
  if (!newest_) return nullptr;
  auto read = nlohmann::ordered_json::array();
  for (const Read& tag : newest_->read) {
    const auto place = places_.find(tag.hit.uid);
    nlohmann::ordered_json json = {{"uid", tag.hit.uid},
                                   {"rssi", nullptr},
                                   {"at", std::to_string(tag.hit.utime)},
                                   {"count", tag.count},
                                   {"place", nullptr}};
    if (tag.hit.rssi) json["rssi"] = *tag.hit.rssi;
    if (place != places_.end()) json["place"] = vector_json(place->second);
    read.push_back(std::move(json));
  }
  nlohmann::ordered_json pose = nullptr;
  if (newest_->X_WR) pose = {newest_->X_WR->x, newest_->X_WR->y, newest_->X_WR->heading};
  return {{"utime", std::to_string(newest_->utime)},
          {"pose", std::move(pose)},
          {"expected", newest_->expected},
          {"read", std::move(read)},
          {"missed", newest_->missed},
          {"unexpected", newest_->unexpected}};
}

}  // namespace markservo::mmi
