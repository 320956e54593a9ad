#include "common/reflection/lcm_language.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace markservo::reflection {
namespace {

const std::map<std::string, Kind>& primitives() {
  static const std::map<std::string, Kind> kinds = {
      {"int8_t", Kind::kInt8},   {"int16_t", Kind::kInt16},   {"int32_t", Kind::kInt32},
      {"int64_t", Kind::kInt64}, {"byte", Kind::kByte},       {"float", Kind::kFloat},
      {"double", Kind::kDouble}, {"boolean", Kind::kBoolean}, {"string", Kind::kString}};
  return kinds;
}

bool is_word(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '_' || character == '.';
}

// Words, and everything else character by character; comments are left out.
class Tokens {
 public:
  Tokens(const std::string& text, std::string origin) : text_(text), origin_(std::move(origin)) { advance(); }

  const std::string& now() const { return token_; }  // empty: the end
  std::string take() {
    std::string token = token_;
    if (token.empty()) complain("the text ends", "more of a type");
    advance();
    return token;
  }
  bool take_if(const std::string& wanted) {
    if (token_ != wanted) return false;
    advance();
    return true;
  }
  void expect(const std::string& wanted) {
    if (!take_if(wanted)) complain("'" + token_ + "'", "'" + wanted + "'");
  }
  std::string name() {
    if (token_.empty() || std::isalpha(static_cast<unsigned char>(token_[0])) + (token_[0] == '_') == 0) {
      complain("'" + token_ + "'", "a name");
    }
    return take();
  }
  [[noreturn]] void complain(const std::string& what, const std::string& allowed) const {
    throw std::invalid_argument(origin_ + ":" + std::to_string(line_) + ": " + what + "; allowed here: " + allowed);
  }

 private:
  void skip_to(const std::string& end) {
    while (at_ < text_.size() && text_.compare(at_, end.size(), end) != 0) step();
    for (std::size_t i = 0; i < end.size() && at_ < text_.size(); ++i) step();
  }
  void step() {
    if (text_[at_] == '\n') ++line_;
    ++at_;
  }
  void advance() {
    while (at_ < text_.size()) {
      if (text_.compare(at_, 2, "//") == 0) {
        skip_to("\n");
      } else if (text_.compare(at_, 2, "/*") == 0) {
        skip_to("*/");
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        step();
      } else {
        break;
      }
    }
    token_.clear();
    if (at_ >= text_.size()) return;
    if (!is_word(text_[at_])) {
      token_ = text_[at_++];
      return;
    }
    while (at_ < text_.size() && is_word(text_[at_])) token_ += text_[at_++];
  }

  const std::string& text_;
  std::string origin_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::string token_;
};

int field_index(const MessageType& type, const std::string& name) {
  for (std::size_t i = 0; i < type.fields.size(); ++i) {
    if (type.fields[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

bool counts(const Field& field) {
  return field.dimensions.empty() && (field.kind == Kind::kInt8 || field.kind == Kind::kInt16 ||
                                      field.kind == Kind::kInt32 || field.kind == Kind::kInt64);
}

// As lcm-gen reads it: decimal, hexadecimal (0x) or octal (0). Nothing for what is no such number, or no int64_t.
std::optional<std::int64_t> integer_of(const std::string& text) {
  char* end = nullptr;
  errno = 0;
  const long long number = std::strtoll(text.c_str(), &end, 0);
  if (text.empty() || *end != '\0' || errno != 0) return std::nullopt;
  return number;
}

// The constants of a type: they are no fields, but give arrays their sizes, and fields' values their names.
class Constants {
 public:
  // Reads what follows "const".
  void parse(Tokens& tokens) {
    const std::string type = tokens.name();
    do {
      const std::string name = tokens.name();
      tokens.expect("=");
      std::string value;
      while (tokens.now() != "," && tokens.now() != ";") value += tokens.take();
      const std::optional<std::int64_t> number = integer_of(value);
      const bool is_real = type == "float" || type == "double";
      if (!is_real && !number) tokens.complain("constant " + name + " = '" + value + "'", "a whole number");
      if (!is_real) sizes_[name] = value;
      if (number) extend_rows(name, *number);
    } while (tokens.take_if(","));
    tokens.expect(";");
  }

  // The text of a whole number, as written; null: there is no such constant.
  const std::string* find(const std::string& name) const {
    const auto found = sizes_.find(name);
    return found == sizes_.end() ? nullptr : &found->second;
  }

  void name_values_of(MessageType& type) const {
    auto row = rows_.begin();
    for (Field& field : type.fields) {
      if (row == rows_.end()) return;
      if (field.kind == Kind::kInt8 && field.dimensions.empty()) field.value_names = *row++;
    }
  }

 private:
  using Row = std::map<std::int64_t, std::string>;

  void extend_rows(const std::string& name, std::int64_t value) {
    if (value == 0) rows_.emplace_back();
    if (!rows_.empty() && value == static_cast<std::int64_t>(rows_.back().size())) rows_.back()[value] = name;
  }

  std::map<std::string, std::string> sizes_;
  std::vector<Row> rows_;
};

Dimension parse_dimension(Tokens& tokens, const MessageType& type, const Constants& constants) {
  constexpr std::int64_t kLargest = 999'999'999;  // arrays beyond that are no message
  constexpr const char* kAllowed = "a whole number above 0, a constant, or an integer field before it";
  const std::string written = tokens.take();
  const std::string* constant = constants.find(written);
  Dimension dimension;
  dimension.text = constant != nullptr ? *constant : written;
  if (constant != nullptr || std::isdigit(static_cast<unsigned char>(written[0])) != 0) {
    dimension.size = integer_of(dimension.text).value_or(0);
    if (dimension.size < 1 || dimension.size > kLargest) tokens.complain("array size '" + written + "'", kAllowed);
  } else {
    dimension.length_field = field_index(type, written);
    if (dimension.length_field < 0 || !counts(type.fields[static_cast<std::size_t>(dimension.length_field)])) {
      tokens.complain("array size '" + written + "'", kAllowed);
    }
  }
  tokens.expect("]");
  return dimension;
}

void parse_fields(Tokens& tokens, MessageType& type, const Constants& constants) {
  const std::string type_name = tokens.name();
  const auto primitive = primitives().find(type_name);
  do {
    Field field;
    field.name = tokens.name();
    field.kind = primitive != primitives().end() ? primitive->second : Kind::kMessage;
    field.type_name = type_name;
    if (field.kind == Kind::kMessage && type_name.find('.') == std::string::npos && !type.package.empty()) {
      field.type_name = type.package + "." + type_name;
    }
    if (field_index(type, field.name) >= 0) tokens.complain("a second field '" + field.name + "'", "a new name");
    while (tokens.take_if("[")) field.dimensions.push_back(parse_dimension(tokens, type, constants));
    type.fields.push_back(std::move(field));
  } while (tokens.take_if(","));
  tokens.expect(";");
}

MessageType named_type(Tokens& tokens, const std::string& package) {
  MessageType type;
  type.package = package;
  type.name = tokens.name();
  const std::size_t dot = type.name.rfind('.');
  if (dot != std::string::npos) {
    type.package = type.name.substr(0, dot);
    type.name.erase(0, dot + 1);
  }
  return type;
}

MessageType parse_struct(Tokens& tokens, const std::string& package) {
  MessageType type = named_type(tokens, package);
  Constants constants;
  tokens.expect("{");
  while (!tokens.take_if("}")) {
    if (tokens.take_if("const")) {
      constants.parse(tokens);
    } else if (!tokens.take_if(";")) {
      parse_fields(tokens, type, constants);
    }
  }
  constants.name_values_of(type);
  return type;
}

// A value without a number is one above the largest before it, which is at least 0: so lcm-gen has it.
MessageType parse_enum(Tokens& tokens, const std::string& package) {
  MessageType type = named_type(tokens, package);
  type.is_enum = true;
  Field value;
  value.name = "value";
  value.kind = Kind::kEnum;
  std::int64_t largest = 0;
  tokens.expect("{");
  while (!tokens.take_if("}")) {
    const std::string name = tokens.name();
    std::int64_t number = largest + 1;
    if (tokens.take_if("=")) {
      const std::string sign = tokens.take_if("-") ? "-" : "";
      const std::string text = sign + tokens.take();
      const std::optional<std::int64_t> given = integer_of(text);
      if (!given) tokens.complain(name + " = '" + text + "'", "a whole number");
      number = *given;
    }
    largest = std::max(largest, number);
    if (!value.value_names.emplace(number, name).second) {
      tokens.complain(name + " = " + std::to_string(number), "a value that no other name has");
    }
    if (!tokens.take_if(",")) tokens.take_if(";");
  }
  type.fields.push_back(std::move(value));
  return type;
}

}  // namespace

std::vector<MessageType> parse_types(const std::string& text, const std::string& origin) {
  Tokens tokens(text, origin);
  std::vector<MessageType> types;
  std::string package;
  while (!tokens.now().empty()) {
    if (tokens.take_if("package")) {
      package = tokens.name();
      tokens.expect(";");
    } else if (tokens.take_if("struct")) {
      types.push_back(parse_struct(tokens, package));
    } else if (tokens.take_if("enum")) {
      types.push_back(parse_enum(tokens, package));
    } else if (!tokens.take_if(";")) {
      tokens.complain("'" + tokens.now() + "'", "package, struct or enum");
    }
  }
  return types;
}

}  // namespace markservo::reflection
