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

// As the .lcm files say behind the fields: what is known only where another field says so.
struct Condition {
  const char* type;
  const char* field;
  const char* value;                // of `field`, as text
  std::vector<const char*> values;  // the type's fields that are known only then
  bool unless = false;              // or then not
};

// Likewise: what is 0, all of it, where it is not known.
struct ZeroWhileUnknown {
  const char* type;
  std::vector<const char*> values;
};

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> all = {
      {"BaseGoal", "kind", "DRIVE", {"pose"}},
      {"ChannelStatus", "age", "-1", {"age", "latency_p50", "latency_p99"}, true},
      {"JointState", "contact_known", "true", {"contact"}},
      {"LocatedMark", "status", "LOCATED", {"p_C", "covariance", "normal_C"}},
      {"MarkView", "seen", "true", {"x", "y", "width", "height", "area", "u", "v", "m_uu", "m_uv", "m_vv"}},
      {"PaperLocalisation",
       "measured_known",
       "true",
       {"utime", "measured_x", "measured_y", "delay", "compensated_x", "compensated_y"}},
      {"PaperLocalisation", "direction_known", "true", {"direction", "speed"}},
      {"RfidTagHit", "read_time_known", "true", {"read_utime"}},
      {"RfidTagHit", "rssi_known", "true", {"rssi"}},
      {"ServoGoal", "kind", "SERVO", {"p_TG_C", "tolerance"}},
      {"TaskCommand", "expected_known", "true", {"p_CT_expected"}},
      {"TaskCommand", "drive", "true", {"drive_pose"}},
  };
  return all;
}

const std::vector<ZeroWhileUnknown>& zeros() {
  static const std::vector<ZeroWhileUnknown> all = {
      {"BaseStatus", {"distance", "heading_error"}},
      {"LocatedMark", {"normal_C"}},
      {"MarkPatch", {"x", "y", "width", "height"}},
      {"ServoStatus", {"error_C", "covariance"}},
  };
  return all;
}

bool holds(const Condition& condition, const Fields& fields) {
  for (std::size_t i = 0; i < fields.values.size(); ++i) {
    const Field& field = fields.type->fields[i];
    if (field.name != condition.field) continue;
    return (reflection::text_of(field, fields.values[i]) == condition.value) != condition.unless;
  }
  return true;  // a type of this name, but not ours
}

bool is_zero(const Value& value) {
  if (const auto* number = std::get_if<double>(&value.content)) return *number == 0.0;
  if (const auto* number = std::get_if<std::int64_t>(&value.content)) return *number == 0;
  const auto* nested = std::get_if<Fields>(&value.content);
  return nested != nullptr && std::all_of(nested->values.begin(), nested->values.end(), is_zero);
}

bool is_zero(const ZeroWhileUnknown& zero, const Fields& fields) {
  return std::all_of(zero.values.begin(), zero.values.end(), [&fields](const char* name) {
    const Value* value = fields.find(name);
    return value != nullptr && is_zero(*value);
  });
}

void leave_out(const std::vector<const char*>& values, Fields& fields) {
  for (std::size_t i = 0; i < fields.values.size(); ++i) {
    const auto is_this = [&](const char* name) { return fields.type->fields[i].name == name; };
    if (std::any_of(values.begin(), values.end(), is_this)) fields.values[i] = {List{}};
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
  for (const Condition& condition : conditions()) {
    if (fields.type->name == condition.type && !holds(condition, fields)) leave_out(condition.values, fields);
  }
  for (const ZeroWhileUnknown& zero : zeros()) {
    if (fields.type->name == zero.type && is_zero(zero, fields)) leave_out(zero.values, fields);
  }
  for (Value& value : fields.values) look_into(value);
}

}  // namespace markservo::log_tool
