#pragma once

#include <functional>

#include "services/mmi/server/server_device.hpp"
#include "services/mmi/site_node.hpp"

namespace markservo::mmi {

// What a source is heard by, as bus::Bus has it.
struct Heard {
  int descriptor = -1;  // readable when something waits; -1: none
  int openings = 0;     // another number for another descriptor
};

// Serves `site` at `place` in this thread, says where the page is, and calls `work` between: whenever `heard`'s
// descriptor has something, and every 20 ms. Until `work` returns false. What `work` or a client's handler throws is
// logged, and it goes on; but bus::LogNotWritten, bus::BusUnavailable and ConfigurationError end it.
void serve(SiteNode& site, const ListenPlace& place, const std::function<Heard()>& heard,
           const std::function<bool()>& work);

}  // namespace markservo::mmi
