#include "services/mmi/live_source_node.hpp"

#include "common/bus/robot_channel.hpp"
#include "common/reflection/message_json.hpp"
#include "common/time/clocks.hpp"
#include "services/mmi/stop/stop_json.hpp"

namespace markservo::mmi {
namespace {

// While this process gets no turn: 60 MB of pictures, which are shown no more when they are old, and 10 s of all else,
// in which no change of state may be missed.
constexpr bus::WaitingMessages kMostWaiting{30, 4000};

WorldReader::Parameters world_parameters(const text::TypedCommand& typed) {
  WorldReader::Parameters parameters;
  parameters.narrator.typed = typed;
  return parameters;
}

// All clients see the same.
class LiveShown final : public Shown {
 public:
  explicit LiveShown(WorldReader& world) : world_(world) {}
  WorldReader& world() override { return world_; }
  const EventLog& events() override { return world_.events(); }
  std::int64_t utime() override { return wall_clock_us(); }
  std::string control(const ClientWord& /*message*/) override {
    return "play, pause, seek or step of a robot; allowed: of a log";
  }

 private:
  WorldReader& world_;
};

}  // namespace

LiveSourceNode::LiveSourceNode(const robot::RobotDescription& robot, const std::string& tag_field,
                               const text::TypedCommand& typed, const std::string& command_token)
    : world_(robot, tag_field, world_parameters(typed)), requester_(robot.stop_devices) {
  if (command_token.empty()) return;
  desk_.emplace(robot, command_token, [this] { return requester_.number_another(); });
  commands_.emplace(*desk_, robot.stop_devices);
}

void LiveSourceNode::start(bus::Bus& bus) {
  bus_ = &bus;
  prefix_ = bus::robot_channel(bus.robot(), "");
  bus.on_each(channels::kStopState, [this](const StopState& state) { on_stop_state(state); });
  bus.on_each(channels::kStop, [this](const StopRequest& request) { on_stop(request); });
  stops_.emplace(bus.advertise(channels::kStop));
  if (commands_) commands_->start(bus);
  bus.on_all(kMostWaiting, [this](const bus::HeardBytes& message) { on_message(message); });
}

void LiveSourceNode::on_message(const bus::HeardBytes& message) {
  world_.observe(message.channel.substr(prefix_.size()), message.data, message.size, message.utime, steady_seconds());
}

void LiveSourceNode::on_stop_state(const StopState& state) {
  task::StopReport report;
  report.device = state.device;
  report.latched = state.latched != 0;
  report.answers_us = state.request_session == bus_->session() && state.request_id == requester_.request_id();
  report.reason = state.reason;
  requester_.observe(report, state.utime, steady_seconds());
  if (commands_) commands_->observe(state);
}

void LiveSourceNode::on_stop(const StopRequest& request) {
  if (request.kind == StopRequest::RESET) requester_.observe({request.session, request.request_id, request.utime});
}

std::unique_ptr<Shown> LiveSourceNode::shown() {
  return std::make_unique<LiveShown>(world_);
}

std::string LiveSourceNode::stop(const std::string& reason) {
  requester_.request(reason, steady_seconds());
  send_stop();
  return {};
}

void LiveSourceNode::send_stop() {
  const auto due = requester_.due(steady_seconds());
  if (!due) return;
  StopRequest stop{};
  stop.utime = due->utime;
  stop.session = bus_->session();
  stop.request_id = due->request_id;
  stop.kind = StopRequest::STOP;
  stop.source = "page";
  stop.reason = due->reason;
  stops_->publish(stop);
}

void LiveSourceNode::tick() {
  const double now = steady_seconds();
  send_stop();
  if (commands_) commands_->tick();
  world_.advance(wall_clock_us(), now);
  std::string text = reflection::json_text(stop_json(requester_.view(now)), -1);
  if (text != stop_state_.text) stop_state_ = {stop_state_.version + 1, std::move(text)};
}

}  // namespace markservo::mmi
