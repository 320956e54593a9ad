#pragma once

#include <map>
#include <string>

#include "services/mmi/server/web_site.hpp"

namespace markservo::mmi {

// The page's files, read once: a request names one of them or nothing, so that no path leads out of the folder.
class PageFiles {
 public:
  // Takes `folder`'s index.html and what lies beside it; a page that says how to build ours where there is none.
  explicit PageFiles(const std::string& folder);

  // For "/", "/app.js", ... without a query; null: there is no such file.
  const Answer* find(const std::string& path) const;
  bool is_built() const { return built_; }

 private:
  std::map<std::string, Answer> files_;
  bool built_ = false;
};

}  // namespace markservo::mmi
