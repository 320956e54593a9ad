#include "services/log-tool/csv_table.hpp"

#include "common/text/text.hpp"

namespace markservo::log_tool {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string escaped = "\"";
  for (const char character : text) {
    if (character == '"') escaped += '"';
    escaped += character;
  }
  return escaped + '"';
}

std::string cell_of(const reflection::Leaf& leaf) {
  const std::string text =
      leaf.field == nullptr ? reflection::text_of(leaf.value) : reflection::text_of(*leaf.field, leaf.value);
  return quoted(text::printable(text));
}

}  // namespace

void CsvColumns::learn(const std::vector<reflection::Leaf>& leaves) {
  for (const reflection::Leaf& leaf : leaves) {
    if (index_.emplace(leaf.path, columns_.size()).second) columns_.push_back(leaf.path);
  }
}

std::string CsvColumns::header() const {
  std::string line = "log_utime";
  for (const std::string& column : columns_) line += "," + quoted(column);
  return line + "\n";
}

std::string CsvColumns::row(std::int64_t log_utime, const std::vector<reflection::Leaf>& leaves) const {
  std::vector<std::string> cells(columns_.size());
  for (const reflection::Leaf& leaf : leaves) {
    const auto column = index_.find(leaf.path);
    if (column != index_.end()) cells[column->second] = cell_of(leaf);
  }
  std::string line = std::to_string(log_utime);
  for (const std::string& cell : cells) line += "," + cell;
  return line + "\n";
}

}  // namespace markservo::log_tool
