#include "services/recorder/recorder_node.hpp"

#include <algorithm>
#include <string>

#include "common/bus/host_name.hpp"
#include "common/bus/network_check.hpp"
#include "common/time/clocks.hpp"
#include "services/recorder/logger/logger_arguments.hpp"
#include "services/recorder/manifest/manifest_file.hpp"
#include "services/recorder/manifest/manifest_words.hpp"
#include "services/recorder/manifest/source_reader.hpp"
#include "services/recorder/places_node.hpp"
#include "services/recorder/proc_reader.hpp"
#include "services/recorder/refusal.hpp"
#include "services/recorder/terminal.hpp"

namespace markservo::recorder {
namespace {

constexpr int kWell = 0;
constexpr int kFaulty = 1;
constexpr int kBadFolder = 2;
constexpr int kNoBus = 3;
constexpr int kInterrupted = 130;  // as a shell says it of Ctrl-C

constexpr std::int64_t kLook_us = 500'000;
constexpr std::int64_t kShortest_us = 10'000;

}  // namespace

RecorderNode::RecorderNode(const RecorderOptions& options, SignalQueue& signals)
    : options_(options),
      signals_(signals),
      folder_(new_folder_of(options, signals)),
      runs_(options.plan, folder_, signals) {
  if (!folder_.lock()) throw Refusal(kBadFolder, folder_.path() + ": a recording goes there already");
}

int RecorderNode::run() {
  try {
    check_disk();
    begin_manifest();
    join_bus();
  } catch (...) {
    remove_manifest(folder_.path());
    folder_.undo();
    throw;
  }
  // Not before: what never began must not take the place of the last recording.
  if (options_.out.empty()) point_latest_to(options_.places.logs_dir, folder_.name());
  warn_of_small_buffer();
  began_us_ = steady_clock_us();
  say("recording " + shown(folder_.path(), options_) + " from " + options_.plan.lcm_url + "; Ctrl-C ends it");
  watch();
  return finish();
}

void RecorderNode::check_disk() {
  free_mb_ = folder_.free_mb();
  if (free_mb_ >= options_.plan.min_free_mb) return;
  throw Refusal(kBadFolder, folder_.path() + ": " + std::to_string(free_mb_) +
                                " MB are free on its disk, less than --min-free " +
                                std::to_string(options_.plan.min_free_mb) + "; nothing was recorded");
}

void RecorderNode::begin_manifest() {
  const Places& places = options_.places;
  ManifestBeginning beginning;
  beginning.name = folder_.name();
  beginning.start_utime = wall_clock_us();
  beginning.host = bus::host_name();
  beginning.lcm_version = lcm_version();
  if (!places.installed) beginning.source = source_version(places.project);
  beginning.types = message_types();
  const ReadConfiguration read = read_configuration(places.config_dir, places.robot_file, places.project);
  beginning.configuration = read.kept;
  manifest_ = begun_manifest(beginning, options_.plan);
  const bool written = write_manifest(folder_.path(), manifest_) && folder_.reserve();
  // What it holds may be incomplete then: Ctrl-C also ends what gathered it.
  give_up_if_told();
  if (!written) throw Refusal(kBadFolder, folder_.path() + ": the manifest cannot be written; nothing was recorded");
  for (const std::string& path : read.unreadable) warn(path + ": cannot be read; the manifest goes without it");
}

void RecorderNode::join_bus() {
  if (runs_.begin()) {
    word_.emplace(options_.plan, folder_.path());
    return;
  }
  runs_.end();
  give_up_if_told();
  const LoggerWords& words = runs_.words();
  const std::string advice =
      words.says_no_route() ? bus::multicast_route_advice() : "lcm-logger says: " + words.first_line();
  throw Refusal(kNoBus, "bus " + options_.plan.lcm_url + ": cannot be joined; nothing was recorded; " + advice);
}

void RecorderNode::warn_of_small_buffer() const {
  const auto asked = asked_receive_buffer(options_.plan.lcm_url);
  const auto largest = largest_receive_buffer();
  if (!options_.plan.frames || !asked || !largest) return;
  const std::int64_t granted = std::min(*asked, *largest);
  if (granted >= bus::kReceiveBufferForRawFrames) return;
  warn(
      "the receive buffer is " + std::to_string(granted) +
      " bytes (net.core.rmem_max or recv_buf_size): raw frames would be lost, JPEG frames are not; for raw frames run: "
      "sysctl -w net.core.rmem_max=4194304");
}

// Ends without a trace when it was told to before anything was recorded.
void RecorderNode::give_up_if_told() {
  if (signals_.told()) throw Refusal(kInterrupted, "");
}

void RecorderNode::watch() {
  while (true) {
    ended_by_ = reason_to_end();
    if (ended_by_) return;
    if (!runs_.is_alive()) {
      if (!resume()) return;
    } else if (!runs_.can_hear()) {
      if (!rejoin()) return;
    }
    remove_old_parts();
    show_progress();
    tell(true, "");
    std::int64_t pause_us = kLook_us;
    if (options_.plan.duration_s) {
      pause_us = std::clamp(*options_.plan.duration_s * 1'000'000 - recorded_us(), kShortest_us, kLook_us);
    }
    signals_.wait(pause_us);
    runs_.words();
  }
}

std::optional<EndReason> RecorderNode::reason_to_end() {
  free_mb_ = folder_.free_mb();
  return recorder::reason_to_end(options_.plan, {signals_.told(), recorded_us(), free_mb_});
}

// lcm-logger died: begins the next part, and notes in the manifest what was missed. False when the recording ends
// instead.
bool RecorderNode::resume() {
  const LoggerEnd end = runs_.end();
  if (end.is_own_word()) {
    ended_by_ = EndReason::kLoggerFailed;
    failed_as_ = end;
    return false;
  }
  return go_on_after(runs_.missed_since(), end, text_of(end));
}

// lcm-logger is deaf: ends it, and begins the next part when there is a bus again; else as resume().
bool RecorderNode::rejoin() {
  runs_.end();
  return go_on_after(runs_.heard_until(), {}, "its network interface went away");
}

// Nothing is recorded since `from_utime`: goes on in the next part. False as resume().
bool RecorderNode::go_on_after(std::int64_t from_utime, const LoggerEnd& end, const std::string& reason) {
  const std::vector<Part> parts = folder_.parts();
  if (!parts.empty() && parts.back().bytes == 0) folder_.remove(parts.back().name);
  ++interruptions_;
  begin_gap(&manifest_, from_utime, end, reason);
  write_manifest(folder_.path(), manifest_);
  if (!is_terminal()) warn(reason + ": the recording goes on in the next part");
  if (!begin_again(reason + ": it goes on in the next part")) return false;
  end_gap(&manifest_, runs_.listens_since());
  write_manifest(folder_.path(), manifest_);
  return true;
}

// Until there is a logger that listens; false when the recording ends instead.
bool RecorderNode::begin_again(const std::string& why) {
  while (true) {
    tell(false, why);
    const std::int64_t until_us = steady_clock_us() + runs_.pause_us();
    while (true) {
      ended_by_ = reason_to_end();
      if (ended_by_) return false;
      const std::int64_t left_us = until_us - steady_clock_us();
      if (left_us <= 0) break;
      signals_.wait(std::min(left_us, kLook_us));
      tell(false, why);
    }
    if (runs_.begin()) return true;
    runs_.end();
  }
}

void RecorderNode::remove_old_parts() {
  if (!options_.plan.keep_parts) return;
  const auto keep = static_cast<std::size_t>(*options_.plan.keep_parts);
  for (const std::string& old : parts_to_remove(folder_.parts(), keep)) {
    folder_.remove(old);
    ++removed_;
  }
}

void RecorderNode::show_progress() const {
  if (!is_terminal()) return;
  constexpr std::int64_t kMegabyte = 1'000'000;
  show("recording " + shown(folder_.path(), options_) + ": " + std::to_string(recorded_us() / 1'000'000) + " s, " +
       std::to_string(folder_.recorded_bytes() / kMegabyte) + " MB, " + std::to_string(free_mb_) +
       " MB free; Ctrl-C ends it");
}

void RecorderNode::tell(bool recording, const std::string& why) {
  word_->tell({recording, folder_.recorded_bytes(), free_mb_, static_cast<int>(folder_.parts().size()), why},
              steady_clock_us());
}

int RecorderNode::finish() {
  const LoggerEnd last = runs_.end();
  const LoggerEnd logger = failed_as_.value_or(last);
  const std::int64_t end_utime = wall_clock_us();
  const LoggerWords& words = runs_.words();
  ended_by_ = reason_in_the_end(*ended_by_, logger, words.says_disk_is_full());
  tell(false, fault_of(*ended_by_, logger, options_.plan, free_mb_).value_or(""));
  remove_old_parts();
  folder_.release_reserve();
  const ManifestEnd end{text_of(*ended_by_), end_utime, logger.exit_code(), words.all(),
                        folder_.parts(),     removed_,  found_in(folder_)};
  complete(&manifest_, end);
  if (!write_manifest(folder_.path(), manifest_)) {
    throw Refusal(kFaulty, manifest_path(folder_.path()) + ": cannot be written; what was recorded is readable");
  }
  return report(logger);
}

int RecorderNode::report(const LoggerEnd& logger) {
  int code = kWell;
  clear_line();
  if (runs_.words().says_disk_was_slow()) warn("the disk was too slow: lcm-logger dropped messages");
  if (interruptions_ > 0) {
    warn("interrupted " + std::to_string(interruptions_) + " time(s): " + told_of_gaps(manifest_) +
         "; the manifest tells when");
    code = kFaulty;
  }
  if (const auto fault = fault_of(*ended_by_, logger, options_.plan, free_mb_)) {
    warn(*fault + ": the recording ended; what was recorded until then is readable");
    code = kFaulty;
  }
  say("recorded " + shown(folder_.path(), options_) + ": " + told_of_recording(manifest_, options_.commands.log));
  if (folder_.recorded_bytes() == 0) warn("nothing was heard on " + options_.plan.lcm_url);
  return code;
}

std::int64_t RecorderNode::recorded_us() const {
  return steady_clock_us() - began_us_;
}

}  // namespace markservo::recorder
