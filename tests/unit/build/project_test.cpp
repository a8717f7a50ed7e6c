// Tests that sketches of one project can include code from folders next to them. An untrusted sketch can
// include only files of its own folder.
#include "sim/build/project.h"

#include <sys/resource.h>

#include <gmock/gmock.h>

#include "sim/base/program_sandbox.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace project_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const std::string kUses = "void setup() { kp(); }\nvoid loop() {}\n";

class ProjectTest : public SketchTest {
 protected:
  void SetUp() override {
    ::setenv("HOME", (folder_ / "elsewhere").c_str(), 1);
    write("club/common/gains.h", "#include \"kp.h\"\n");
    write("club/common/kp.h", "inline int kp() { return 3; }\n");
    write("club/Robot/Robot.ino", "#include \"../common/gains.h\"\n" + kUses);
  }
  std::string untrusted_error_of(const std::string& name) const {
    try {
      Request request{folder_ / name, *find_board("uno")};
      request.untrusted = true;
      build(request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }
};

TEST_F(ProjectTest, LetsASketchIncludeWhatItSharesWithSketchesBesideIt) {
  EXPECT_EQ(error_of("club/Robot"), "no error");
  write("club/common/kp.h", "#error changed\n");
  EXPECT_THAT(error_of("club/Robot"), HasSubstr("changed")) << "a change of the shared file is noticed";
}

TEST_F(ProjectTest, LetsASketchIncludeWhatItSharesWithItsCheckout) {
  write("club/.git/HEAD", "ref: refs/heads/main\n");
  write("club/robots/2026/Robot/Robot.ino", "#include \"../../../common/gains.h\"\n" + kUses);
  EXPECT_EQ(error_of("club/robots/2026/Robot"), "no error");
}

TEST_F(ProjectTest, EndsAtTheFolderThatTheSketchStandsInAndBeforeTheHomeOfItsUser) {
  const auto shared = [&](const char* name) {
    const Sketch sketch = read_sketch(folder_ / name);
    return shared_files(sketch, reach_of(sketch.folder));
  };
  EXPECT_THAT(shared("club/Robot"),
              ElementsAre(folder_ / "club/common/gains.h", folder_ / "club/common/kp.h"));
  write("club/robots/Robot/Robot.ino", "#include \"../../common/gains.h\"\n" + kUses);
  EXPECT_THAT(shared("club/robots/Robot"), IsEmpty());
  ::setenv("HOME", (folder_ / "club").c_str(), 1);
  EXPECT_THAT(shared("club/Robot"), IsEmpty());
  write("club/Robot/.git/HEAD", "ref: refs/heads/main\n");
  EXPECT_THAT(shared("club/Robot"), IsEmpty()) << "the sketch is a checkout of its own";
}

TEST_F(ProjectTest, SharesNothingThatIsNoSource) {
  write("club/common/notes.txt", "inline int kp() { return 3; }\n");
  write("club/Robot/Robot.ino", "#include \"../common/notes.txt\"\n" + kUses);
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  EXPECT_THAT(error_of("club/Robot"),
              AllOf(StartsWith("Robot.ino:1:10: ../common/notes.txt is not a readable file of"),
                    HasSubstr("--libraries DIR")));
}

TEST_F(ProjectTest, SharesNothingWithASketchThatIsSomebodyElses) {
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  EXPECT_EQ(error_of("club/Robot"), "no error");
  EXPECT_THAT(untrusted_error_of("club/Robot"),
              StartsWith("Robot.ino:1:10: ../common/gains.h is not a readable file of the sketch"))
      << "although the trusted sketch was compiled before";
}

TEST_F(ProjectTest, FindsALinkThatLeadsOutOfAFolder) {
  write("club/Robot/src/own.h", "");
  std::filesystem::create_symlink("own.h", folder_ / "club/Robot/src/link.h");
  EXPECT_NO_THROW(check_links(folder_ / "club/Robot"));
  for (const char* target : {"/", "../../common/kp.h", "/nowhere"}) {
    std::filesystem::remove(folder_ / "club/Robot/src/away");
    std::filesystem::create_symlink(target, folder_ / "club/Robot/src/away");
    EXPECT_THROW(check_links(folder_ / "club/Robot"), InputError) << target;
  }
}

TEST_F(ProjectTest, FindsThatASketchsFolderIsALink) {
  std::filesystem::create_directory_symlink("Robot", folder_ / "club/Other");
  for (const char* name : {"club/Other", "club/Other/"})
    EXPECT_THROW(check_links(folder_ / name), InputError)
        << "a pupil is not graded by another's sketch: " << name;
  EXPECT_NO_THROW(check_links(folder_ / "club/Robot/"));
}

TEST_F(ProjectTest, AcceptsNoFolderInWhichItCannotLookForLinksEverywhere) {
  std::string deep = "club/Robot/src";
  for (int i = 0; i < 100; ++i) deep += "/n";
  write(deep + "/own.h", "");
  EXPECT_NO_THROW(check_links(folder_ / "club/Robot"));
  rlimit files{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &files), 0);
  rlimit few = files;
  few.rlim_cur = 60;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  EXPECT_THROW(check_links(folder_ / "club/Robot"), InputError) << "each level needs a descriptor";
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &files), 0);
}

}  // namespace project_test
}  // namespace robosim::build
