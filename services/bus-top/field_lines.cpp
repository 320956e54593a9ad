#include "services/bus-top/field_lines.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "common/reflection/value_text.hpp"
#include "services/bus-top/channel_table.hpp"

namespace markservo::bus_top {
namespace {

using reflection::Fields;
using reflection::List;
using reflection::Value;

class Writer {
 public:
  explicit Writer(const FieldLinesParameters& parameters) : parameters_(parameters) {}

  void write(const Fields& fields, std::size_t depth) {
    std::size_t width = 0;
    for (const auto& field : fields.type->fields) width = std::max(width, field.name.size());
    for (std::size_t i = 0; i < fields.values.size(); ++i) {
      write(fields.type->fields[i], fields.type->fields[i].name, fields.values[i], depth, width);
    }
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  void write(const reflection::Field& field, const std::string& name, const Value& value, std::size_t depth,
             std::size_t width) {
    if (const auto* nested = std::get_if<Fields>(&value.content)) {
      line(depth, name);
      write(*nested, depth + 1);
    } else if (const auto* list = std::get_if<List>(&value.content)) {
      write_list(field, name, *list, depth, width);
    } else {
      line(depth, fmt::format("{:<{}}  {}", name, width, plain(field, value)));
    }
  }

  void write_list(const reflection::Field& field, const std::string& name, const List& list, std::size_t depth,
                  std::size_t width) {
    const bool is_plain = std::all_of(list.begin(), list.end(), [](const Value& value) {
      return !std::holds_alternative<Fields>(value.content) && !std::holds_alternative<List>(value.content);
    });
    if (is_plain) {
      line(depth, fmt::format("{:<{}}  {}", name, width, row(field, list)));
      return;
    }
    const std::size_t shown = std::min(list.size(), parameters_.messages);
    for (std::size_t i = 0; i < shown; ++i) write(field, fmt::format("{}[{}]", name, i), list[i], depth, width);
    if (shown < list.size()) line(depth, fmt::format("{}: {} more", name, list.size() - shown));
  }

  std::string row(const reflection::Field& field, const List& list) const {
    std::string text = "[";
    const std::size_t shown = std::min(list.size(), parameters_.numbers);
    for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : ", ") + plain(field, list[i]);
    return shown < list.size() ? fmt::format("{}, ... {} in all]", text, list.size()) : text + "]";
  }

  static std::string plain(const reflection::Field& field, const Value& value) {
    if (const auto* bytes = std::get_if<reflection::Bytes>(&value.content)) {
      return size_text(static_cast<double>(bytes->size));
    }
    const std::string text = reflection::printable(reflection::text_of(field, value));
    return std::holds_alternative<std::string>(value.content) ? '"' + text + '"' : text;
  }

  void line(std::size_t depth, const std::string& text) { lines_.push_back(std::string(2 * depth, ' ') + text); }

  FieldLinesParameters parameters_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> field_lines(const Fields& fields, const FieldLinesParameters& parameters) {
  Writer writer(parameters);
  writer.write(fields, 0);
  return writer.take();
}

}  // namespace markservo::bus_top
