#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "services/mmi/troubles/words.hpp"

namespace markservo::mmi {

// Who writes under which session, by SERVICE_STATUS.
class SessionNames {
 public:
  void observe(const ServiceWord& word, double now);

  // The service's name; empty where it is not known.
  std::string service(std::int64_t session) const;
  // "target-locator (process 12 on host)", or "session 34" where it is not known.
  std::string words(std::int64_t session) const;

 private:
  struct Service {
    std::string name;
    std::string host;
    int pid = 0;
    double heard = 0.0;  // s
  };

  std::map<std::int64_t, Service> services_;
};

}  // namespace markservo::mmi
