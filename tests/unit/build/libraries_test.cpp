#include "sim/build/libraries.h"

#include <gmock/gmock.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace libraries_test {

using testing::ElementsAre;
using testing::NotNull;

TEST_F(SketchTest, ALibraryWithSrcIsCompiledAtAnyDepth) {
  write("libs/Deep/library.properties", "version=1\nname=Deep Library\r\n");
  write("libs/Deep/src/Deep.h", "");
  write("libs/Deep/src/a/b/deep.cpp", "");
  write("libs/Deep/src/fast.c", "");
  write("libs/Deep/examples/x/x.cpp", "");
  write("libs/Deep/test.cpp", "");
  const LibraryFinder finder({folder_ / "libs"});
  const Library* library = finder.find("Deep.h");
  ASSERT_THAT(library, NotNull());
  EXPECT_EQ(library->name, "Deep Library");
  EXPECT_THAT(library->includes, ElementsAre(folder_ / "libs/Deep/src"));
  EXPECT_THAT(library->sources, ElementsAre("src/a/b/deep.cpp", "src/fast.c"));
}

TEST_F(SketchTest, AFlatLibraryIsItsRootAndUtility) {
  write("libs/Flat/Flat.h", "");
  write("libs/Flat/Flat.cpp", "");
  write("libs/Flat/utility/help.cpp", "");
  write("libs/Flat/extras/no.cpp", "");
  const LibraryFinder finder({folder_ / "libs"});
  const Library* library = finder.find("Flat.h");
  ASSERT_THAT(library, NotNull());
  EXPECT_THAT(library->includes, ElementsAre(folder_ / "libs/Flat", folder_ / "libs/Flat/utility"));
  EXPECT_THAT(library->sources, ElementsAre("Flat.cpp", "utility/help.cpp"));
}

TEST_F(SketchTest, OfSeveralLibrariesWithAHeaderTheOneOfItsNameIsTaken) {
  for (const char* name : {"Another", "Servo-master", "Servo"})
    write(std::string("libs/") + name + "/Servo.h", "");
  const LibraryFinder all({folder_ / "libs"});
  EXPECT_EQ(all.find("Servo.h")->folder, folder_ / "libs/Servo");
  std::filesystem::remove_all(folder_ / "libs/Servo");
  const LibraryFinder two({folder_ / "libs"});
  EXPECT_EQ(two.find("Servo.h")->name, "Servo-master");
  EXPECT_EQ(two.find("Missing.h"), nullptr);
}

TEST_F(SketchTest, AnEarlierFolderWinsAndAFolderMayBeALibraryItself) {
  write("one/Sonar/Sonar.h", "");
  write("two/Sonar/Sonar.h", "");
  const LibraryFinder one_first({folder_ / "none", folder_ / "one", folder_ / "two"});
  EXPECT_EQ(one_first.find("Sonar.h")->folder, folder_ / "one/Sonar");
  const LibraryFinder itself({folder_ / "two/Sonar", folder_ / "one"});
  EXPECT_EQ(itself.find("Sonar.h")->folder, folder_ / "two/Sonar");
}

TEST_F(SketchTest, LibrariesAreFoundBesideAndInsideTheSketchInHomeAndInOurs) {
  write("All/All.ino",
        "#include <Inside.h>\n#include <Sibling.h>\n#include <AtHome.h>\n#include <PidController.h>\n" +
            kEmptySketch);
  write("All/libraries/Inside/Inside.h", "#include <FromInside.h>\n");
  write("All/libraries/FromInside/FromInside.h", "int from_inside();\n");
  write("All/libraries/FromInside/FromInside.cpp",
        "#include \"FromInside.h\"\nint from_inside() { return 1; }\n");
  write("All/Sibling/Sibling.h", "");
  write("home/Arduino/libraries/AtHome/AtHome.h", "");
  EXPECT_THAT(build_here("All").libraries,
              ElementsAre("Inside", "FromInside", "Sibling", "AtHome", "LineKit"));
}

TEST_F(SketchTest, LibrariesAreFoundWhereArduinosIdeKeepsThem) {
  write("Ide/Ide.ino", "#include <Book.h>\n#include <Snap.h>\n" + kEmptySketch);
  write("home/.arduino15/preferences.txt",
        "board=uno\nsketchbook.path=" + (folder_ / "my book").string() + "\n");
  write("my book/libraries/Book/Book.h", "");
  write("home/snap/arduino/current/Arduino/libraries/Snap/Snap.h", "");
  EXPECT_THAT(build_here("Ide").libraries, ElementsAre("Book", "Snap"));
}

}  // namespace libraries_test
}  // namespace robosim::build
