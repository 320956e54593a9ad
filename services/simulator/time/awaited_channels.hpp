#pragma once

// Whom lockstep waits for: channels that answer a frame, and channels that answer an odometry.

#include <string>
#include <vector>

namespace markservo::simulator {

struct AwaitedChannels {
  std::vector<std::string> of_frames;
  std::vector<std::string> of_odometries;
};

// All that lockstep may wait for.
const std::vector<std::string>& answering_channels();

// False: it answers a frame.
bool answers_odometry(const std::string& channel);

// `channels`, each an answering one, by what they answer.
AwaitedChannels awaited_channels(const std::vector<std::string>& channels);

}  // namespace markservo::simulator
