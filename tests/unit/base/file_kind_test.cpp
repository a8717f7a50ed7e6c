#include "sim/base/file_kind.h"

#include <gmock/gmock.h>

#include "sim/base/error.h"

namespace robosim::file_kind_test {

TEST(FileKind, IsToldByTheContent) {
  EXPECT_EQ(kind_of("+++\nname = \"x\"\n+++\n111\n"), FileKind::map);
  EXPECT_EQ(kind_of("__1__\n__1__\n"), FileKind::map);
  EXPECT_EQ(kind_of("# mine\nbase = \"uno5\"\n"), FileKind::robot);
  EXPECT_EQ(kind_of("[chassis]\nmass = \"1 kg\"\n"), FileKind::robot);
  EXPECT_EQ(kind_of("\n[[check]]\nname = \"a\"\nrobot = \"uno5\"\n"), FileKind::checks);
  EXPECT_EQ(kind_of("map = \"oval\"\n[[agent]]\nname = \"A\"\n"), FileKind::fleet);
  EXPECT_EQ(kind_of("# first\nat 2s press start\n"), FileKind::script);
  EXPECT_EQ(kind_of("\xEF\xBB\xBFsetting\nafter serial \"x\" lift\n"), std::nullopt);
  EXPECT_EQ(kind_of("\xEF\xBB\xBF"
                    "after serial \"x\" lift\n"),
            FileKind::script);
  EXPECT_EQ(kind_of("#include <Servo.h>\nint x;\nvoid setup() {\n}\n"), FileKind::sketch);
  EXPECT_EQ(kind_of("\x7F"
                    "ELF"),
            FileKind::image);
  EXPECT_EQ(kind_of(":100000000C9434000C943E000C943E000C943E0082\n"), FileKind::image);
  EXPECT_EQ(kind_of("# robosim calibration log 1\nt_us,S1\n"), FileKind::log);
  EXPECT_EQ(kind_of("robosim.rec/1\n{}\n"), FileKind::recording);
  EXPECT_EQ(kind_of("sketch,map,robot\nx,y,z\n"), FileKind::table);
  EXPECT_EQ(kind_of("hello\n"), std::nullopt);
  EXPECT_EQ(kind_of(""), std::nullopt);
}

TEST(FileKind, OfAnotherKindIsNamedWithTheOptionForIt) {
  const auto refusal = [](std::string_view text, FileKind wanted) -> std::string {
    try {
      return read_as(wanted, text, "a.txt", []() -> std::string { throw InputError("as it was"); });
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refusal("base = \"uno5\"\n", FileKind::map),
            "a.txt: expected a map, got a robot file; give it with --robot");
  EXPECT_EQ(refusal("111\n", FileKind::robot), "a.txt: expected a robot file, got a map; give it with --map");
  EXPECT_EQ(refusal("t_us,a,b\n", FileKind::robot),
            "a.txt: expected a robot file, got a calibration log; robosim calibrate ROBOT LOG reads it");
  EXPECT_EQ(refusal("111\n", FileKind::map), "as it was") << "a map with another fault";
  EXPECT_EQ(refusal("what is this\n", FileKind::map), "as it was");
}

}  // namespace robosim::file_kind_test
