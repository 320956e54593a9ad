#include "services/mmi/scene/state_names.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/reflection/type_catalog.hpp"

namespace markservo::mmi {

std::vector<std::string> state_names(const std::string& type, const std::string& field) {
  const reflection::MessageType* found = reflection::TypeCatalog::ours().find(type);
  if (found == nullptr) throw std::invalid_argument("no message type '" + type + "'; allowed: those of lcmtypes");
  const auto named = std::find_if(found->fields.begin(), found->fields.end(), [&](const reflection::Field& candidate) {
    return candidate.name == field && !candidate.value_names.empty();
  });
  if (named == found->fields.end()) {
    throw std::invalid_argument("no field '" + field + "' of " + type + "; allowed: those that constants name");
  }
  std::vector<std::string> names;
  for (const auto& [number, name] : named->value_names) names.push_back(name);
  return names;
}

}  // namespace markservo::mmi
