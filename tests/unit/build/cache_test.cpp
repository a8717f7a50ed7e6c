#include "sim/build/cache.h"

#include <gmock/gmock.h>

#include <atomic>
#include <csignal>
#include <thread>
#include <vector>

#include "sim/base/child.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace cache_test {

namespace fs = std::filesystem;

class CacheTest : public SketchTest {
 protected:
  CacheTest() : cache_(folder_ / "cache") {}
  Entry store(const Inputs& inputs, const std::string& key = "key") const {
    return cache_.store(key, inputs, "result of " + key, "made.o", {{"fact", "two\nlines \\n"}},
                        fs::file_time_type::clock::now() + std::chrono::hours(1));
  }
  Cache cache_;
};

TEST_F(CacheTest, AnEntryIsFoundWithItsFactsAndResult) {
  const Entry stored = store({{write("in put.h", "x")}, {folder_}});
  const auto found = cache_.find("key");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->result, stored.result);
  EXPECT_EQ(read_file(found->result), "result of key");
  EXPECT_EQ(found->facts.at("fact"), "two\nlines \\n");
  EXPECT_FALSE(cache_.find("another key"));
}

TEST_F(CacheTest, AnEntryHoldsByContentNotByTime) {
  const fs::path input = write("input.h", "x");
  store({{input}, {}});
  write("input.h", "y");
  EXPECT_FALSE(cache_.find("key"));
  write("input.h", "x");
  EXPECT_TRUE(cache_.find("key"));
  fs::remove(input);
  EXPECT_FALSE(cache_.find("key"));
}

TEST_F(CacheTest, KeysAndContentsAreComparedBySha256ForAStrangerMayChooseThem) {
  const fs::path input = write("input.h", "x");
  const Entry stored = store({{input}, {}});
  const std::string text = read_file(folder_ / "cache/entries" / sha256("key"));
  EXPECT_THAT(text, testing::HasSubstr(" made-" + sha256("result of key").substr(0, 32) + ".o\n"));
  EXPECT_THAT(text, testing::HasSubstr("file " + sha256("x") + " " + input.string()));
  EXPECT_EQ(stored.result.filename(), "made-" + sha256("result of key").substr(0, 32) + ".o");
}

TEST_F(CacheTest, AResultIsNotReplacedByAnEqualOneSinceASandboxAllowsOnlyThatFile) {
  const Entry stored = store({});
  const fs::path other_name = folder_ / "other name";
  fs::create_hard_link(stored.result, other_name);
  store({}, "key");
  EXPECT_TRUE(fs::equivalent(stored.result, other_name));
}

TEST_F(CacheTest, AFolderCountsByItsNamesAndMayAppearLater) {
  const fs::path folder = folder_ / "libraries";
  store({{}, {folder}});
  EXPECT_TRUE(cache_.find("key"));
  fs::create_directories(folder);
  EXPECT_FALSE(cache_.find("key"));
  store({{}, {folder}});
  EXPECT_TRUE(cache_.find("key"));
  write("libraries/x.h", "");
  EXPECT_FALSE(cache_.find("key"));
}

TEST_F(CacheTest, AnInputThatChangedDuringTheWorkIsNotRemembered) {
  const Inputs inputs{{write("input.h", "x")}, {}};
  const Entry entry = cache_.store("key", inputs, "made", "made.o", {},
                                   fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_EQ(read_file(entry.result), "made");
  EXPECT_FALSE(cache_.find("key"));
}

TEST_F(CacheTest, ATornEntryOrResultIsNotUsed) {
  const Entry stored = store({});
  ASSERT_TRUE(cache_.find("key"));
  for (const auto& file : fs::directory_iterator(folder_ / "cache/entries"))
    fs::resize_file(file, fs::file_size(file) - 4);
  EXPECT_FALSE(cache_.find("key"));
  store({});
  ASSERT_TRUE(cache_.find("key"));
  write_file(stored.result, "other");
  EXPECT_FALSE(cache_.find("key"));
}

TEST_F(CacheTest, AWorkFolderIsNewAndGoesAway) {
  fs::path path;
  {
    const WorkFolder first(cache_);
    const WorkFolder second(cache_);
    path = first.path();
    EXPECT_TRUE(fs::is_empty(path));
    EXPECT_NE(path, second.path());
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(CacheTest, TheWorkFolderOfAKilledProcessGoesWithTheNextOne) {
  const WorkFolder mine(cache_);
  const fs::path left = folder_ / "cache/work/left";
  Child killed([&] {
    const WorkFolder folder(cache_);
    fs::create_directories(folder.path() / "deep");
    fs::create_symlink(folder.path(), left);
    ::raise(SIGKILL);
    return 0;
  });
  killed.wait();
  const fs::path its = fs::read_symlink(left);
  fs::remove(left);
  ASSERT_TRUE(fs::exists(its / "deep"));
  const WorkFolder next(cache_);
  EXPECT_FALSE(fs::exists(its));
  EXPECT_TRUE(fs::exists(mine.path())) << "a folder in use is not removed";
}

TEST_F(CacheTest, AFolderInThePlaceOfAnEntryOrAResultGoes) {
  const Entry stored = store({});
  for (const auto& file : fs::directory_iterator(folder_ / "cache/entries")) {
    const fs::path entry = file.path();
    fs::remove(entry);
    fs::create_directories(entry / "x");
  }
  fs::remove(stored.result);
  fs::create_directories(stored.result / "x");
  EXPECT_FALSE(cache_.find("key"));
  store({});
  EXPECT_TRUE(cache_.find("key"));
}

TEST_F(SketchTest, TheCacheIsNowhereThatARunnerCannotBeTold) {
  ::unsetenv("XDG_CACHE_HOME");
  ::setenv("HOME", (folder_ / "h\xFF").c_str(), 1);
  ::setenv("TMPDIR", folder_.c_str(), 1);
  EXPECT_THAT(cache_folder().string(), testing::StartsWith((folder_ / "robosim-").string()));
}

TEST_F(SketchTest, TheCacheIsWhereTheUserSays) {
  ::setenv("XDG_CACHE_HOME", (folder_ / "xdg").c_str(), 1);
  EXPECT_EQ(cache_folder(), folder_ / "xdg/robosim");
  ::unsetenv("XDG_CACHE_HOME");
  EXPECT_EQ(cache_folder(), folder_ / "home/.cache/robosim");
  write("file", "");
  ::setenv("HOME", (folder_ / "file").c_str(), 1);
  ::setenv("TMPDIR", folder_.c_str(), 1);
  EXPECT_THAT(cache_folder().string(), testing::StartsWith((folder_ / "robosim-").string()));
}

TEST_F(SketchTest, TheCacheIsNeverOneThatAnotherUserOwns) {
  ::setenv("XDG_CACHE_HOME", (folder_ / "xdg").c_str(), 1);
  ASSERT_EQ(cache_folder(), folder_ / "xdg/robosim");
  if (::geteuid() == 0)
    ASSERT_EQ(::chown((folder_ / "xdg/robosim").c_str(), 65534, 65534), 0);
  else
    fs::permissions(folder_ / "xdg/robosim", fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_EQ(cache_folder(), folder_ / "home/.cache/robosim");
}

TEST_F(CacheTest, EachOfSeveralBuildsAtOnceHasItsFolder) {
  std::atomic<int> missing{0};
  std::vector<std::thread> builds;
  for (int i = 0; i < 4; ++i)
    builds.emplace_back([&] {
      for (int n = 0; n < 300; ++n)
        if (const WorkFolder folder(cache_); !fs::is_directory(folder.path())) ++missing;
    });
  for (std::thread& build : builds) build.join();
  EXPECT_EQ(missing, 0);
}

}  // namespace cache_test
}  // namespace robosim::build
