#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <string>
#include <tuple>

namespace markservo::mmi {

// Tells a new request from a repeat of one of the last `most`.
class RequestMemory {
 public:
  explicit RequestMemory(std::size_t most) : most_(most) {}

  // True if the request has not been heard before, or so long ago that it is forgotten.
  bool is_new(const std::string& channel, std::int64_t session, std::int64_t id) {
    const Request request(channel, session, id);
    if (!known_.insert(request).second) return false;
    order_.push_back(request);
    if (order_.size() > most_) {
      known_.erase(order_.front());
      order_.pop_front();
    }
    return true;
  }

 private:
  using Request = std::tuple<std::string, std::int64_t, std::int64_t>;

  std::size_t most_;
  std::set<Request> known_;
  std::deque<Request> order_;
};

}  // namespace markservo::mmi
