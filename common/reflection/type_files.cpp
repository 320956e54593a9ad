#include "common/reflection/type_files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

#include "common/reflection/lcm_language.hpp"

namespace markservo::reflection {
namespace {

namespace fs = std::filesystem;

constexpr const char* kAllowed = "; allowed: a file in LCM's type language (struct, enum), or a folder of .lcm files";

std::vector<std::string> files_of(const std::string& path) {
  std::error_code error;
  if (!fs::is_directory(path, error)) return {path};
  std::vector<std::string> files;
  try {
    for (const auto& entry : fs::recursive_directory_iterator(path)) {
      if (entry.path().extension() == ".lcm" && entry.is_regular_file()) files.push_back(entry.path().string());
    }
  } catch (const fs::filesystem_error& failure) {
    throw std::invalid_argument(path + ": " + failure.code().message() + kAllowed);
  }
  if (files.empty()) throw std::invalid_argument(path + ": holds no .lcm file" + kAllowed);
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_in(const std::string& path) {
  constexpr std::size_t kLargest = 10'000'000;  // bytes; a type file has some thousand
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    throw std::invalid_argument(path + ": " + (error ? error.message() : "is no file") + kAllowed);
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::invalid_argument(path + ": " + std::strerror(errno) + kAllowed);
  std::string text(std::min<std::uintmax_t>(fs::file_size(path), kLargest + 1), '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  // A log is often called .lcm too.
  if (text.size() > kLargest || text.find('\0') != std::string::npos) {
    throw std::invalid_argument(path + ": is no text (a log?)" + kAllowed);
  }
  return text;
}

bool same(const Field& one, const Field& other) {
  return one.name == other.name && one.type_name == other.type_name && one.value_names == other.value_names &&
         std::equal(one.dimensions.begin(), one.dimensions.end(), other.dimensions.begin(), other.dimensions.end(),
                    [](const Dimension& a, const Dimension& b) { return a.text == b.text && a.size == b.size; });
}

bool same(const MessageType& one, const MessageType& other) {
  return one.is_enum == other.is_enum &&
         std::equal(one.fields.begin(), one.fields.end(), other.fields.begin(), other.fields.end(),
                    [](const Field& a, const Field& b) { return same(a, b); });
}

// That a row of constants names a field's values is our convention: others' constants may mean anything.
void forget_value_names(MessageType& type) {
  if (type.is_enum || type.package == kOurPackage) return;
  for (Field& field : type.fields) field.value_names.clear();
}

}  // namespace

TypeCatalog types_with(const std::vector<std::string>& paths) {
  std::map<std::string, std::pair<MessageType, std::string>> types;  // by full name, with the file
  for (const std::string& path : paths) {
    for (const std::string& file : files_of(path)) {
      for (MessageType& type : parse_types(text_in(file), file)) {
        forget_value_names(type);
        const auto [known, is_new] = types.try_emplace(type.full_name(), type, file);
        if (is_new || same(known->second.first, type)) continue;
        throw std::invalid_argument(file + ": type " + known->first + " is another one in " + known->second.second +
                                    "; allowed: one definition of a type");
      }
    }
  }
  std::vector<MessageType> all;
  for (auto& entry : types) all.push_back(std::move(entry.second.first));
  try {
    return TypeCatalog(std::move(all), &TypeCatalog::ours());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) + "; allowed: types of the files given by --types, and ours");
  }
}

}  // namespace markservo::reflection
