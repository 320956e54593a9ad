#include "tests/system/fault_campaign/history.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <lcm/lcm-cpp.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace markservo::campaign {
namespace {

constexpr std::int64_t kHeardWithin_us = 3'000'000;  // what was sent comes back, or was lost

const std::string kCut = "CUT:";
const std::string kSent = "SENT:";

Event event_of(const lcm::LogEvent& logged) {
  Event event;
  event.t = logged.timestamp;
  event.channel = logged.channel;
  const auto* data = static_cast<const std::uint8_t*>(logged.data);
  event.data.assign(data, data + logged.datalen);
  event.size = logged.datalen;
  return event;
}

// "CUT:<bytes>:<channel>" is taken apart.
void restore_cut(Event& event) {
  if (event.channel.rfind(kCut, 0) != 0) return;
  const std::size_t colon = event.channel.find(':', kCut.size());
  if (colon == std::string::npos) return;
  event.size = std::stoll(event.channel.substr(kCut.size(), colon - kCut.size()));
  event.channel = event.channel.substr(colon + 1);
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

void mark_foreign(const std::vector<Event>& sent, std::vector<Event>& heard) {
  std::map<std::string, std::vector<Event*>> by_channel;
  for (Event& event : heard) by_channel[event.channel].push_back(&event);
  for (const Event& own : sent) {
    auto& candidates = by_channel[own.channel];
    auto first = std::lower_bound(candidates.begin(), candidates.end(), own.t,
                                  [](const Event* event, std::int64_t t) { return event->t < t; });
    for (; first != candidates.end() && (*first)->t <= own.t + kHeardWithin_us; ++first) {
      if ((*first)->foreign || (*first)->size != own.size || (*first)->data != own.data) continue;
      (*first)->foreign = true;
      break;
    }
  }
}

History load_history(const std::string& folder) {
  const std::filesystem::path path(folder);
  History history;
  std::vector<Event> sent;
  lcm::LogFile log((path / "history.lcm").string(), "r");
  if (!log.good()) throw std::runtime_error(folder + "/history.lcm: cannot be read");
  while (const lcm::LogEvent* logged = log.readNextEvent()) {
    Event event = event_of(*logged);
    const bool own = event.channel.rfind(kSent, 0) == 0;
    if (own) event.channel = event.channel.substr(kSent.size());
    restore_cut(event);
    (own ? sent : history.events).push_back(std::move(event));
  }
  mark_foreign(sent, history.events);
  std::ifstream facts(path / "facts.jsonl");
  if (!facts) throw std::runtime_error(folder + "/facts.jsonl: cannot be read");
  for (std::string line; std::getline(facts, line);) {
    if (!line.empty()) history.facts.push_back(nlohmann::json::parse(line));
  }
  if (std::filesystem::is_directory(path / "printed")) {
    for (const auto& file : std::filesystem::recursive_directory_iterator(path / "printed")) {
      if (file.is_regular_file()) history.printed[file.path().filename().string()] = text_of_file(file.path());
    }
  }
  return history;
}

HistoryWriter::HistoryWriter(const std::string& folder) {
  const std::filesystem::path path(folder);
  std::filesystem::create_directories(path);
  log_ = std::make_unique<lcm::LogFile>((path / "history.lcm").string(), "w");
  if (!log_->good()) throw std::runtime_error(folder + "/history.lcm: cannot be written");
  facts_.reset(std::fopen((path / "facts.jsonl").c_str(), "w"), [](std::FILE* file) {
    if (file != nullptr) std::fclose(file);
  });
  if (!facts_) throw std::runtime_error(folder + "/facts.jsonl: cannot be written");
}

void HistoryWriter::heard(std::int64_t t, const std::string& channel, std::int64_t size, const std::uint8_t* data,
                          std::size_t available) {
  write(t, "", channel, size, data, available);
}

void HistoryWriter::sent(std::int64_t t, const std::string& channel, const std::vector<std::uint8_t>& data) {
  write(t, kSent, channel, static_cast<std::int64_t>(data.size()), data.data(), data.size());
}

void HistoryWriter::write(std::int64_t t, const std::string& prefix, const std::string& channel, std::int64_t size,
                          const std::uint8_t* data, std::size_t available) {
  const bool cut = size > static_cast<std::int64_t>(kWholeSize) || static_cast<std::int64_t>(available) < size;
  lcm::LogEvent event{};
  event.eventnum = number_++;
  event.timestamp = t;
  event.channel = prefix + (cut ? kCut + std::to_string(size) + ":" : "") + channel;
  event.datalen = static_cast<std::int32_t>(cut ? std::min(available, kCutSize) : available);
  event.data = const_cast<std::uint8_t*>(data);
  log_->writeEvent(&event);
}

void HistoryWriter::fact(std::int64_t t, nlohmann::json fact) {
  fact["t"] = t;
  const std::string line = fact.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  std::fputs(line.c_str(), facts_.get());
  std::fflush(facts_.get());
}

}  // namespace markservo::campaign
