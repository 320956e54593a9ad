#pragma once

// Whether a bus can be joined just now, found out without liblcm: it prints, waits 10 s, or aborts where it cannot.

#include <string>

namespace markservo::bus {

struct Reachability {
  enum class Kind {
    kReachable,
    kMissing,  // a route, an interface or a server: waiting mends it
    kDeaf,     // what is sent does not come back: a firewall, or a group that another holds; waiting may mend it
    kNever,    // the URL is wrong, or no file descriptors are left: waiting does not mend it
  };
  Kind kind = Kind::kReachable;
  std::string reason;  // what is missing or wrong, and what to do; empty when reachable
};

// Of udpm:// and tcpq:// URLs; all others are left to liblcm. `listens`: the bus is read too. Takes up to 0.3 s where
// what is sent does not come back, 0.5 s where a server does not answer, else a millisecond. Sends what liblcm does at
// its start, LCM_SELF_TEST, kept on this host.
Reachability reach(const std::string& url, bool listens);

}  // namespace markservo::bus
