#include "services/mmi/page_files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace markservo::mmi {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::string>& content_types() {
  static const std::map<std::string, std::string> types{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".txt", "text/plain; charset=utf-8"},
  };
  return types;
}

constexpr const char* kNotBuilt = R"(<!doctype html>
<html lang="en">
<title>markservo</title>
<h1>The page is not built yet</h1>
<p>It is built with the programs where npm is there and reaches its registry. In the checkout:</p>
<pre>
sudo apt-get install npm
scripts/build
</pre>
<p>Then reload. What the robot does and what is wrong: <a href="/state.json">state.json</a>.
To stop it: <code>scripts/task stop</code>.</p>
</html>
)";

}  // namespace

PageFiles::PageFiles(const std::string& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    const auto type = content_types().find(entry.path().extension().string());
    if (type == content_types().end() || !entry.is_regular_file(none)) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    auto body = std::make_shared<std::string>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    files_["/" + entry.path().filename().string()] = {200, type->second, std::move(body)};
  }
  const auto index = files_.find("/index.html");
  built_ = index != files_.end();
  files_["/"] =
      built_ ? index->second : Answer{200, content_types().at(".html"), std::make_shared<std::string>(kNotBuilt)};
}

const Answer* PageFiles::find(const std::string& path) const {
  const auto file = files_.find(path);
  return file == files_.end() ? nullptr : &file->second;
}

}  // namespace markservo::mmi
