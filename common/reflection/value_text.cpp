#include "common/reflection/value_text.hpp"

#include <algorithm>
#include <charconv>
#include <type_traits>

namespace markservo::reflection {
namespace {

void add_leaves(const std::string& path, const Field& field, const Value& value, std::vector<Leaf>& leaves);

void add_leaves(const std::string& path, const Fields& fields, std::vector<Leaf>& leaves) {
  for (std::size_t i = 0; i < fields.values.size(); ++i) {
    const Field& field = fields.type->fields[i];
    add_leaves((path.empty() ? "" : path + ".") + field.name, field, fields.values[i], leaves);
  }
}

void add_leaves(const std::string& path, const Field& field, const Value& value, std::vector<Leaf>& leaves) {
  if (const auto* list = std::get_if<List>(&value.content)) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      add_leaves(path + "[" + std::to_string(i) + "]", field, (*list)[i], leaves);
    }
  } else if (const auto* fields = std::get_if<Fields>(&value.content)) {
    add_leaves(path, *fields, leaves);
  } else {
    leaves.push_back({path, value, &field});
  }
}

std::string number_text(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number);
  return {text, end.ptr};
}

}  // namespace

std::vector<Leaf> leaves(const Fields& fields) {
  std::vector<Leaf> found;
  add_leaves("", fields, found);
  return found;
}

std::string text_of(const Value& value) {
  return std::visit(
      [](const auto& content) -> std::string {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, Bytes>) return std::to_string(content.size) + " bytes";
        if constexpr (std::is_same_v<Content, double>) return number_text(content);
        if constexpr (std::is_same_v<Content, bool>) return content ? "true" : "false";
        if constexpr (std::is_same_v<Content, std::int64_t>) return std::to_string(content);
        if constexpr (std::is_same_v<Content, std::string>) return content;
        return {};
      },
      value.content);
}

std::string text_of(const Field& field, const Value& value) {
  const auto* number = std::get_if<std::int64_t>(&value.content);
  const auto name = number == nullptr ? field.value_names.end() : field.value_names.find(*number);
  return name == field.value_names.end() ? text_of(value) : name->second;
}

std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char character) { return character < ' ' || character > '~'; }, '?');
  return text;
}

}  // namespace markservo::reflection
