#include "services/task-operator/asked_bus.hpp"

#include <fmt/core.h>

namespace markservo::task_operator {
namespace {

constexpr std::size_t kMostTold = 4;  // a whole stack has ten

}  // namespace

std::string told_of_bus(const std::string& url, const std::set<std::string>& services) {
  if (services.empty()) {
    return fmt::format("asked on {}, where no service speaks: is it another bus (--lcm-url) or robot (--robot)?", url);
  }
  const std::size_t told = services.size() <= kMostTold ? services.size() : kMostTold - 1;
  std::string names;
  std::size_t i = 0;
  for (const std::string& name : services) {
    if (i == told) break;
    const bool is_last = i + 1 == services.size();
    names += (i == 0 ? "" : is_last ? " and " : ", ") + name;
    ++i;
  }
  if (told < services.size()) names += fmt::format(" and {} more", services.size() - told);
  return fmt::format("asked on {}, where {} {}", url, names, services.size() == 1 ? "speaks" : "speak");
}

}  // namespace markservo::task_operator
