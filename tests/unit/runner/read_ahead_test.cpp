#include "sim/runner/read_ahead.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"
#include "sim/base/file.h"
#include "tests/support/temporary_folder.h"

namespace robosim::runner::read_ahead_test {

class ReadingAhead : public testing::Test {
 protected:
  ReadingAhead() {
    write_file(base_, read_file(robot::find_robot("uno5")));
    write_file(robot_, "base = \"./base.toml\"\n");
    write_file(image_, "one");
    write_file(map_, kMap);
    request_.robot = robot_.string();
    request_.image = image_.string();
    request_.map = map_.string();
  }

  const robot::Description* read() {
    ahead_ = read_ahead(request_, {0}, std::move(ahead_), now_);
    const auto found = ahead_.robots.find(request_.robot);
    return found == ahead_.robots.end() ? nullptr : found->second.get();
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path robot_ = folder_.path() / "own.toml", base_ = folder_.path() / "base.toml",
                              image_ = folder_.path() / "a.so";
  wire::RunRequest request_;
  ReadAhead ahead_;

  long long now_ = wall_ns();
  static constexpr const char* kMap = "_____\n_..._\n_____\n";
  const std::filesystem::path map_ = folder_.path() / "a.map";

  const ReadMap* read_the_map() {
    read();
    return ahead_.map.get();
  }
  /// Advances the clock by an hour, so that all files were written long ago.
  void let_files_settle() { now_ += 3'600'000'000'000; }
};

TEST_F(ReadingAhead, WhatFilesStillHoldIsNotReadAgain) {
  const robot::Description* const robot = read();
  const exec::ImageContent* const image = ahead_.images.at(request_.image).content.get();
  ASSERT_TRUE(robot);
  EXPECT_TRUE(image->is_like(image_));
  EXPECT_EQ(read(), robot);
  EXPECT_EQ(ahead_.images.at(request_.image).content.get(), image);
}

TEST_F(ReadingAhead, NorIsARobotForItsDescriptionUnlessItHasChanged) {
  const std::shared_ptr<const robot::Description> robot = known_robot(request_.robot, {});
  EXPECT_EQ(known_robot(request_.robot, {{request_.robot, robot}}), robot);
  write_file(base_, read_file(base_) + "# changed\n");
  EXPECT_NE(known_robot(request_.robot, {{request_.robot, robot}})->sha256, robot->sha256);
  std::filesystem::remove(base_);
  EXPECT_THROW(known_robot(request_.robot, {{request_.robot, robot}}), InputError);
}

// The times of a recently written file do not prove that the file is unchanged. Only the bytes of the file
// prove this.
TEST_F(ReadingAhead, AnImageThatIsWrittenAnewIsSeenAtOnce) {
  for (const char* content : {"one", "two", "tw", "", "three"}) {
    write_file(image_, content);
    read();
    EXPECT_TRUE(ahead_.images.at(request_.image).content->is_like(image_)) << content;
    write_file(image_, "another");
    EXPECT_FALSE(ahead_.images.at(request_.image).content->is_like(image_)) << content;
  }
  std::filesystem::remove(image_);
  EXPECT_THROW(read(), InputError);
}

// The write of "two" may leave the file's times unchanged, if the file system's clock has not advanced.
TEST_F(ReadingAhead, Addr2lineIsAskedOnceForTheSameAddressesOfAnImage) {
  read();
  int asked = 0;
  const auto find = [&](std::uintptr_t offset) {
    return ahead_.images.at(request_.image).lines->find({offset}, [&] {
      ++asked;
      return "output " + std::to_string(asked);
    });
  };
  EXPECT_EQ(find(16), "output 1");
  EXPECT_EQ(find(32), "output 2");
  read();
  EXPECT_EQ(find(16), "output 1");
  write_file(image_, "two");
  read();
  EXPECT_EQ(find(16), "output 3");
}

TEST_F(ReadingAhead, OutputsOfAddr2lineTakeAtMostOneMebibyte) {
  KnownLines lines;
  int asked = 0;
  const auto find = [&](std::uintptr_t offset) {
    return lines.find({offset}, [&] {
      ++asked;
      return std::string(400'000, 'x');
    });
  };
  for (const std::uintptr_t offset : {1, 2, 2, 3, 3, 1}) EXPECT_EQ(find(offset).size(), 400'000u);
  EXPECT_EQ(asked, 4);
}

TEST(FileIdentity, IsTrustedOnceTheClockOfItsFileSystemHasGoneOn) {
  constexpr long long kSecond = 1'000'000'000;
  const FileIdentity fine = {1, 2, 3, 500, 123'456'789, 500, 223'456'789};
  EXPECT_FALSE(is_settled(fine, 500 * kSecond + 300'000'000));
  EXPECT_TRUE(is_settled(fine, 500 * kSecond + 400'000'000));
  const FileIdentity coarse = {1, 2, 3, 500, 0, 498, 223'456'789};
  EXPECT_FALSE(is_settled(coarse, 502 * kSecond));
  EXPECT_TRUE(is_settled(coarse, 504 * kSecond));
  EXPECT_FALSE(is_settled(fine, 400 * kSecond)) << "the file system's clock is ahead";
}

TEST_F(ReadingAhead, SoIsAChangeInARobotOrItsBase) {
  for (const char* text : {"[chassis]\nmass = \"210 g\"\n", "[chassis]\nmass = \"220 g\"\n"}) {
    write_file(robot_, std::string("base = \"./base.toml\"\n") + text);
    ASSERT_TRUE(read());
    EXPECT_EQ(read()->sha256, robot::load_description(request_.robot).sha256);
  }
  const std::string before = read()->sha256;
  write_file(base_, read_file(base_) + "# changed\n");
  ASSERT_TRUE(read());
  EXPECT_NE(read()->sha256, before);
  std::filesystem::remove(base_);
  EXPECT_FALSE(read()) << "the run reports the missing file";
}

TEST_F(ReadingAhead, AMapIsReadOnceAndStandsAsSimulationsFindIt) {
  let_files_settle();
  const ReadMap* const map = read_the_map();
  ASSERT_TRUE(map);
  EXPECT_TRUE(map->prepared_map);
  EXPECT_EQ(map->sha256, map::sha256_of_map(map_));
  request_.seed = 2;
  EXPECT_EQ(read_the_map(), map) << "no value of the map has a spread";
  request_.profile = "ideal";
  EXPECT_NE(read_the_map(), map) << "values may depend on the profile";
}

TEST_F(ReadingAhead, SeveralMapsAreKept) {
  std::vector<std::string> names;
  for (const char* name : {"b.map", "c.map", "d.map", "e.map"}) {
    names.push_back((folder_.path() / name).string());
    write_file(names.back(), std::string("+++\nname = \"") + name + "\"\n+++\n" + kMap);
  }
  let_files_settle();
  std::vector<std::shared_ptr<ReadMap>> maps;
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i < names.size(); ++i) {
      request_.map = names[i];
      ASSERT_TRUE(read_the_map());
      EXPECT_EQ(read_the_map()->map.name, std::filesystem::path(names[i]).filename());
      if (round == 0) maps.push_back(ahead_.map);
      EXPECT_EQ(ahead_.map, maps[i]);
    }
  request_.map = map_.string();
  EXPECT_EQ(read_the_map()->map.name, "a");
  EXPECT_EQ(ahead_.maps.size(), 4u) << "the oldest map is gone";
}

TEST_F(ReadingAhead, AMapThatIsWrittenAnewIsSeenAtOnce) {
  for (const bool settle : {false, true})
    for (const char* name : {"one", "two", "three"}) {
      write_file(map_, std::string("+++\nname = \"") + name + "\"\n+++\n" + kMap);
      ASSERT_TRUE(read_the_map());
      if (settle) let_files_settle();
      ASSERT_TRUE(read_the_map());
      EXPECT_EQ(ahead_.map->map.name, name);
    }
  write_file(map_, "_._\n???\n");
  EXPECT_FALSE(read_the_map()) << "the run reports the error";
  std::filesystem::remove(map_);
  EXPECT_FALSE(read_the_map()) << "the run reports the missing map";
}

// A value of the map has a random deviation (`spread`), so each seed gives a different map.
TEST_F(ReadingAhead, AMapWithASpreadIsReadForItsSeed) {
  write_file(map_, std::string("+++\n[[light]]\nlevel = { value = 0.5, spread = 0.1 }\n+++\n") + kMap);
  request_.profile = "typical";
  let_files_settle();
  const auto first = read_the_map() ? ahead_.map : nullptr;
  ASSERT_TRUE(first);
  EXPECT_EQ(read_the_map(), first.get());
  request_.seed = 2;
  EXPECT_NE(read_the_map(), first.get());
  request_.seed = 1;
  EXPECT_EQ(read_the_map(), first.get()) << "the maps of both seeds are stored";
}

}  // namespace robosim::runner::read_ahead_test
