#include "services/mmi/control/lease.hpp"

namespace markservo::mmi {

std::string Lease::hold(std::int64_t client, bool take, double now) {
  const std::int64_t present = holder(now);
  if (present != client) {
    if (present != 0 && !take) return "another operates; allowed: to take it over";
    holder_ = client;
    since_ = now;
  }
  heard_ = now;
  return {};
}

void Lease::give_up(std::int64_t client) {
  if (holder_ == client) holder_ = 0;
}

std::int64_t Lease::holder(double now) const {
  return now - heard_ <= kLasts ? holder_ : 0;
}

}  // namespace markservo::mmi
