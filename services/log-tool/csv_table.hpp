#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/reflection/value_text.hpp"

namespace markservo::log_tool {

// Messages of one channel as rows of comma-separated values (RFC 4180): one column a plain value, named by its path.
// Messages of different lengths share the columns; what a message does not have stays empty. A value that a constant of
// its type names is written by that name.
class CsvColumns {
 public:
  // Learns the columns that a message needs.
  void learn(const std::vector<reflection::Leaf>& leaves);

  // "log_utime,utime,session,...".
  std::string header() const;
  // `log_utime` in us, the logger's.
  std::string row(std::int64_t log_utime, const std::vector<reflection::Leaf>& leaves) const;

 private:
  std::vector<std::string> columns_;
  std::map<std::string, std::size_t> index_;
};

}  // namespace markservo::log_tool
