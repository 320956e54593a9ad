#include "services/mmi/log/log_story_reader.hpp"

#include <algorithm>
#include <markservo/channels.hpp>

namespace markservo::mmi {
namespace {

constexpr std::size_t kMostEvents = 200'000;  // of a log of days; 40 MB
constexpr double kSilenceStep = 0.1;          // s
constexpr double kLongestSilence = 10.0;      // s: by then everything that a silence tells has been told

NarratorReader::Parameters parameters_of(const text::TypedCommand& typed) {
  NarratorReader::Parameters parameters;
  parameters.typed = typed;
  parameters.events = kMostEvents;
  return parameters;
}

}  // namespace

LogStoryReader::LogStoryReader(const LogIndex& index, const robot::RobotDescription& robot,
                               const text::TypedCommand& typed)
    : index_(index), narrator_(robot, parameters_of(typed)) {}

void LogStoryReader::pass_silence(std::int64_t from, std::int64_t to) {
  const double begin = logs::seconds_apart(index_.begin(), from);
  const double seconds = std::min(logs::seconds_apart(from, to), kLongestSilence);
  for (double passed = kSilenceStep; passed < seconds; passed += kSilenceStep) {
    narrator_.advance(from + static_cast<std::int64_t>(1e6 * passed), begin + passed);
  }
}

bool LogStoryReader::read(std::size_t events) {
  const std::size_t until = std::min(index_.events().size(), read_ + events);
  for (; read_ < until; ++read_) {
    const LogIndex::Event& event = index_.events()[read_];
    if (read_ > 0) pass_silence(index_.events()[read_ - 1].at, event.at);
    narrator_.observe(*event.channel, event.data.data, event.data.size, event.at,
                      logs::seconds_apart(index_.begin(), event.at));
  }
  return read_ < index_.events().size();
}

}  // namespace markservo::mmi
