#include "common/reflection/message_json.hpp"

#include <glib.h>

#include <memory>
#include <type_traits>

namespace markservo::reflection {
namespace {

std::string base64(const Bytes& bytes) {
  const std::unique_ptr<gchar, decltype(&g_free)> text(g_base64_encode(bytes.data, bytes.size), g_free);
  return text.get();
}

nlohmann::ordered_json json_of(const Field& field, const Value& value, JsonForm form, std::size_t most_bytes) {
  return std::visit(
      [&](const auto& content) -> nlohmann::ordered_json {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, Bytes>) {
          if (form == JsonForm::kExact && content.size <= most_bytes) return base64(content);
          return {{"bytes", content.size}};
        } else if constexpr (std::is_same_v<Content, List>) {
          auto list = nlohmann::ordered_json::array();
          for (const Value& element : content) list.push_back(json_of(field, element, form, most_bytes));
          return list;
        } else if constexpr (std::is_same_v<Content, Fields>) {
          return reflection::json_of(content, form, most_bytes);
        } else if constexpr (std::is_same_v<Content, std::int64_t>) {
          if (form == JsonForm::kExact && field.kind == Kind::kInt64) return std::to_string(content);
          return content;
        } else {
          return content;
        }
      },
      value.content);
}

}  // namespace

nlohmann::ordered_json json_of(const Fields& fields, JsonForm form, std::size_t most_bytes) {
  auto object = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < fields.values.size(); ++i) {
    const Field& field = fields.type->fields[i];
    object[field.name] = json_of(field, fields.values[i], form, most_bytes);
  }
  return object;
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace markservo::reflection
