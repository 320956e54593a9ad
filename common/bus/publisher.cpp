#include "common/bus/publisher.hpp"

#include <stdexcept>

namespace markservo::bus {

void refuse_to_publish(const std::string& channel, const std::string& why) {
  throw std::invalid_argument("publish on " + channel + ": " + why);
}

}  // namespace markservo::bus
