#pragma once

#include <optional>
#include <string>

namespace markservo::recorder {

// The number of the network interface on which who joins the multicast group now hears it: where the kernel's route to
// it goes. Nothing where there is none.
std::optional<int> interface_towards(const std::string& group);

// Whether there is an interface of that number. One that was taken away and made anew has another.
bool interface_exists(int number);

}  // namespace markservo::recorder
