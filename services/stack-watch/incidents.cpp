#include "services/stack-watch/incidents.hpp"

namespace markservo::stack_watch {

void Kills::add(const Kill& kill) {
  newest_.push_back(kill);
  if (newest_.size() > kKept) newest_.pop_front();
}

std::optional<double> Kills::silent_s(const std::string& name, int pid) const {
  for (auto kill = newest_.rbegin(); kill != newest_.rend(); ++kill) {
    if (kill->name == name && kill->pid == pid) return kill->silent_s;
  }
  return std::nullopt;
}

std::string Kills::told(std::int64_t now_us) const {
  if (newest_.empty() || now_us - newest_.back().utime >= kTold_us) return {};
  const Kill& last = newest_.back();
  return last.name + " (pid " + std::to_string(last.pid) + ") said nothing for " +
         std::to_string(static_cast<int>(last.silent_s)) + " s and was killed";
}

bool CraftedFragments::observe(const std::string& from, std::int64_t now_us) {
  const bool news = now_us - newest_us_ > kTold_us;
  ++count_;
  newest_us_ = now_us;
  newest_from_ = from;
  return news;
}

std::string CraftedFragments::told(std::int64_t now_us) const {
  if (count_ == 0 || now_us - newest_us_ >= kTold_us) return {};
  return std::to_string(count_) + " crafted fragments came, the last from " + newest_from_;
}

}  // namespace markservo::stack_watch
