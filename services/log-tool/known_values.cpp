#include "services/log-tool/known_values.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "common/reflection/value_text.hpp"

namespace markservo::log_tool {
namespace {

using reflection::Field;
using reflection::Fields;
using reflection::List;
using reflection::Value;

// As the .lcm files say behind the fields.
struct Condition {
  const char* type;
  const char* field;
  const char* value;                // of `field`, as text
  std::vector<const char*> values;  // the type's fields that are known only then
};

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> all = {
      {"JointState", "contact_known", "true", {"contact"}},
      {"LocatedMark", "status", "LOCATED", {"p_C", "covariance", "normal_C"}},
      {"MarkView", "seen", "true", {"x", "y", "width", "height", "area", "u", "v", "m_uu", "m_uv", "m_vv"}},
      {"PaperLocalisation", "measured_known", "true", {"measured_x", "measured_y", "compensated_x", "compensated_y"}},
      {"PaperLocalisation", "direction_known", "true", {"direction", "speed"}},
      {"RfidTagHit", "read_time_known", "true", {"read_utime"}},
      {"RfidTagHit", "rssi_known", "true", {"rssi"}},
      {"TaskCommand", "expected_known", "true", {"p_CT_expected"}},
      {"TaskCommand", "drive", "true", {"drive_pose"}},
  };
  return all;
}

bool holds(const Condition& condition, const Fields& fields) {
  for (std::size_t i = 0; i < fields.values.size(); ++i) {
    const Field& field = fields.type->fields[i];
    if (field.name == condition.field) return reflection::text_of(field, fields.values[i]) == condition.value;
  }
  return true;  // a type of this name, but not ours
}

void leave_out(const Condition& condition, Fields& fields) {
  for (std::size_t i = 0; i < fields.values.size(); ++i) {
    const auto is_this = [&](const char* name) { return fields.type->fields[i].name == name; };
    if (std::any_of(condition.values.begin(), condition.values.end(), is_this)) fields.values[i] = {List{}};
  }
}

void look_into(Value& value) {
  if (auto* nested = std::get_if<Fields>(&value.content)) {
    leave_out_unknown(*nested);
  } else if (auto* list = std::get_if<List>(&value.content)) {
    for (Value& element : *list) look_into(element);
  }
}

}  // namespace

void leave_out_unknown(Fields& fields) {
  const bool is_ours = fields.type->package == reflection::kOurPackage;
  for (const Condition& condition : conditions()) {
    if (is_ours && fields.type->name == condition.type && !holds(condition, fields)) leave_out(condition, fields);
  }
  for (Value& value : fields.values) look_into(value);
}

}  // namespace markservo::log_tool
