#include "services/recorder/manifest/source_reader.hpp"

#include <gtest/gtest.h>
#include <sys/fsuid.h>

#include "tests/unit/recorder/scratch_folder.hpp"

namespace markservo::recorder {
namespace {

namespace fs = std::filesystem;

// Whoever may read everything may not while this lives: files are opened as by a user who is nobody here.
class AsNobody {
 public:
  AsNobody() : before_(setfsuid(kNobody)) {}
  ~AsNobody() { setfsuid(static_cast<uid_t>(before_)); }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  static constexpr uid_t kNobody = 65534;
  int before_;
};

class ConfigurationOnDisk : public ::testing::Test {
 protected:
  ConfigurationOnDisk() {
    folder_.write("project/config/robot.yaml", "arm: {}\n");
    folder_.write("project/config/scenes/shelf.yaml", "books: []\n");
  }

  ReadConfiguration read(const std::string& config_dir = "project/config",
                         const std::string& robot_file = "project/config/robot.yaml") const {
    return read_configuration(folder_.path(config_dir), folder_.path(robot_file), project_);
  }
  static std::vector<std::string> paths(const Json& kept) {
    std::vector<std::string> paths;
    for (const Json& file : kept.at("files")) paths.push_back(file.at("path"));
    return paths;
  }

  ScratchFolder folder_{"source_reader_test"};
  std::string project_ = fs::canonical(folder_.path("")).string() + "/project";
};

using Names = std::vector<std::string>;

TEST_F(ConfigurationOnDisk, IsAllThatIsBelowTheFolderAndTheRobotFile) {
  folder_.write("my.yaml", "arm: {mine: 1}\n");
  const ReadConfiguration configuration = read("project/config", "my.yaml");
  EXPECT_EQ(paths(configuration.kept), (Names{"outside/my.yaml", "config/robot.yaml", "config/scenes/shelf.yaml"}));
  EXPECT_EQ(configuration.kept["robot_file"], "outside/my.yaml");
  EXPECT_TRUE(configuration.unreadable.empty());
}

TEST_F(ConfigurationOnDisk, OfAnotherFolderKeepsTheRobotFileThatTheServicesUseInItsPlace) {
  folder_.write("mine/robot.yaml", "arm: {mine: 1}\n");
  const ReadConfiguration configuration = read("mine");
  EXPECT_EQ(paths(configuration.kept), (Names{"outside/robot.yaml", "config/robot.yaml"}));
  EXPECT_EQ(configuration.kept["files"][1]["text"], "arm: {}\n");
  EXPECT_EQ(configuration.kept["robot_file"], "config/robot.yaml");
}

TEST_F(ConfigurationOnDisk, KeepsAnEmptyFileAndNoneThatIsNoSetting) {
  folder_.write("project/config/empty.conf", "");
  folder_.write("project/config/video", std::string(2'000'000, 'x'));
  fs::create_symlink("robot.yaml", folder_.path("project/config/link"));
  EXPECT_EQ(paths(read().kept), (Names{"config/empty.conf", "config/robot.yaml", "config/scenes/shelf.yaml"}));
}

TEST_F(ConfigurationOnDisk, GoesWithoutAFileOrFolderThatCannotBeReadAndNamesIt) {
  folder_.write("project/config/secret.conf", "key=1\n");
  folder_.write("project/config/private/mine.conf", "key=1\n");
  fs::permissions(folder_.path("project/config/secret.conf"), fs::perms::none);
  fs::permissions(folder_.path("project/config/private"), fs::perms::none);
  const ReadConfiguration configuration = [this] {
    const AsNobody nobody;
    return read();
  }();
  EXPECT_EQ(configuration.unreadable, (Names{project_ + "/config/private", project_ + "/config/secret.conf"}));
  EXPECT_EQ(paths(configuration.kept), (Names{"config/robot.yaml", "config/scenes/shelf.yaml"}));
  EXPECT_EQ(configuration.kept["unreadable"], Json({"config/secret.conf"}));
  fs::permissions(folder_.path("project/config/private"), fs::perms::owner_all);
}

}  // namespace
}  // namespace markservo::recorder
