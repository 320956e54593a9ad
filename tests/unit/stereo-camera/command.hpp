#pragma once

// Runs the stereo-camera executable as a person does and reads the log that it writes.

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <lcm/lcm-cpp.hpp>
#include <markservo/StereoFrame.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace markservo::stereo_camera {

struct CommandResult {
  int exit_code = -1;
  std::string output;  // of both streams
};

inline std::string quoted(const std::string& argument) {
  return "'" + argument + "'";
}

inline CommandResult run_stereo_camera(const std::vector<std::string>& arguments) {
  std::string command =
      quoted(MARKSERVO_BIN_DIR "/stereo-camera") + " --robot-file " + quoted(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  command += " 2>&1";
  CommandResult result;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  char buffer[4096];
  while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) result.output += buffer;
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

struct LoggedEvent {
  std::string channel;
  std::string payload;
  bool operator==(const LoggedEvent& other) const { return channel == other.channel && payload == other.payload; }
};

inline std::vector<LoggedEvent> read_events(const std::string& path) {
  lcm::LogFile log(path, "r");
  std::vector<LoggedEvent> events;
  if (!log.good()) return events;
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    events.push_back(
        {event->channel, std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen))});
  }
  return events;
}

inline std::vector<StereoFrame> read_frames(const std::string& path) {
  std::vector<StereoFrame> frames;
  for (const LoggedEvent& event : read_events(path)) {
    StereoFrame frame;
    if (event.channel != "STEREO_FRAME") throw std::runtime_error("unexpected channel " + event.channel);
    if (frame.decode(event.payload.data(), 0, static_cast<int>(event.payload.size())) < 0) {
      throw std::runtime_error("a STEREO_FRAME in " + path + " cannot be decoded");
    }
    frames.push_back(frame);
  }
  return frames;
}

}  // namespace markservo::stereo_camera
