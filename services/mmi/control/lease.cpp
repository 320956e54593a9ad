#include "services/mmi/control/lease.hpp"

namespace markservo::mmi {

void Lease::hold(std::int64_t client, bool take, double now) {
  const std::int64_t present = holder(now);
  if (present != client) {
    if (present != 0 && !take) return;
    holder_ = client;
    since_ = now;
  }
  heard_ = now;
}

void Lease::give_up(std::int64_t client) {
  if (holder_ == client) holder_ = 0;
}

std::int64_t Lease::holder(double now) const {
  return now - heard_ <= kLasts ? holder_ : 0;
}

}  // namespace markservo::mmi
