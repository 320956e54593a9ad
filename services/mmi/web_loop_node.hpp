#pragma once

#include <functional>

#include "services/mmi/server/server_device.hpp"
#include "services/mmi/site_node.hpp"

namespace markservo::bus {
class Bus;
}

namespace markservo::mmi {

// Serves `site` at `place` in this thread, and calls `work` between: whenever `bus` (null: none) has something, and
// every 20 ms. Until `work` returns false.
void serve(SiteNode& site, const ListenPlace& place, const bus::Bus* bus, const std::function<bool()>& work);

}  // namespace markservo::mmi
