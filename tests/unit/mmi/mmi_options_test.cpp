#include "services/mmi/mmi_options.hpp"

#include <gtest/gtest.h>

#include "common/robot/configuration_error.hpp"
#include "services/mmi/page_files.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {
namespace {

TEST(ListenPlace, IsAnAddressWithAPortOrAPath) {
  EXPECT_EQ(listen_place("127.0.0.1:8080").address, "127.0.0.1");
  EXPECT_EQ(listen_place("127.0.0.1:8080").port, 8080);
  EXPECT_EQ(listen_place("[::1]:80").address, "::1");
  EXPECT_EQ(listen_place("localhost:80").address, "127.0.0.1");
  EXPECT_EQ(listen_place("./page.sock").path, "./page.sock");
  EXPECT_TRUE(listen_place("/run/page.sock").is_path());
}

TEST(ListenPlace, IsRefusedWithWhatIsAllowed) {
  for (const char* wrong :
       {"", "8080", ":8080", "127.0.0.1", "127.0.0.1:", "127.0.0.1:0", "127.0.0.1:65536", "127.0.0.1:8080x"}) {
    EXPECT_THROW(listen_place(wrong), ConfigurationError) << wrong;
  }
  EXPECT_THROW(listen_place("/" + std::string(108, 'x')), ConfigurationError);
}

TEST(ListenPlace, IsPrivateOnLoopbackAndByAPath) {
  for (const char* place : {"127.0.0.1:80", "localhost:80", "[::1]:80", "/run/page.sock", "127.0.0.5:80"}) {
    EXPECT_TRUE(is_private(listen_place(place))) << place;
  }
  for (const char* place : {"0.0.0.0:80", "[::]:80", "192.168.1.5:80", "10.0.0.1:80"}) {
    EXPECT_FALSE(is_private(listen_place(place))) << place;
  }
}

TEST(Token, IsTheFilesFirstLine) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(read_token(folder.write("token", "sixteen letters!\nmore")), "sixteen letters!");
  EXPECT_EQ(read_token(folder.write("of_windows", "sixteen letters!\r\n")), "sixteen letters!");
  EXPECT_EQ(read_token(folder.write("longest", std::string(512, 'x'))), std::string(512, 'x'));
}

TEST(Token, IsRefusedWithWhatIsAllowed) {
  const test::TemporaryFolder folder;
  const auto refusal = [](const std::string& path) -> std::string {
    try {
      return "taken: " + read_token(path);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
  };
  EXPECT_NE(refusal(folder.write("short", "guess me\n")).find("8 characters"), std::string::npos);
  EXPECT_NE(refusal(folder.write("short2", "fifteen letters\r\n")).find("15 characters"), std::string::npos);
  EXPECT_NE(refusal(folder.write("empty", "")).find("is empty"), std::string::npos);
  EXPECT_NE(refusal(folder.write("large", std::string(513, 'x'))).find("more than 512 bytes"), std::string::npos);
  EXPECT_NE(refusal(folder.file("none")).find("cannot be read"), std::string::npos);
  EXPECT_NE(refusal(folder.file("")).find("cannot be read"), std::string::npos);
}

TEST(PageFiles, AreThoseOfTheFolderAndNoOthers) {
  const test::TemporaryFolder folder;
  folder.write("index.html", "<!doctype html>");
  folder.write("app.js", "run()");
  folder.write("secret.key", "");
  const PageFiles page(folder.file(""));
  EXPECT_TRUE(page.is_built());
  EXPECT_EQ(*page.find("/")->body, "<!doctype html>");
  EXPECT_EQ(page.find("/app.js")->content_type, "text/javascript; charset=utf-8");
  for (const char* path : {"/secret.key", "/../app.js", "//app.js", "/app.js/", "app.js", "", "/%2e%2e/app.js"}) {
    EXPECT_EQ(page.find(path), nullptr) << path;
  }
}

TEST(PageFiles, SayHowToBuildThemWhereThereAreNone) {
  const test::TemporaryFolder folder;
  const PageFiles page(folder.file("none"));
  EXPECT_FALSE(page.is_built());
  EXPECT_NE(page.find("/")->body->find("scripts/build"), std::string::npos);
}

TEST(CommandToken, IsMadeOnceForItsUserAlone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("token");
  const std::string token = command_token(path);
  EXPECT_EQ(token.size(), 32U);
  EXPECT_EQ(std::filesystem::status(path).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_EQ(command_token(path), token);
  EXPECT_NE(command_token(folder.file("another")), token);
}

TEST(CommandToken, OfAFileThatOthersReadIsNone) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("token");
  command_token(path);
  std::filesystem::permissions(path, std::filesystem::perms::group_read, std::filesystem::perm_options::add);
  EXPECT_THROW(command_token(path), ConfigurationError);
  std::filesystem::create_symlink(path, folder.file("link"));
  EXPECT_THROW(command_token(folder.file("link")), ConfigurationError);
  EXPECT_THROW(command_token(folder.file("no/such/folder")), ConfigurationError);
}

}  // namespace
}  // namespace markservo::mmi
