#include "sim/build/source.h"

#include <gmock/gmock.h>

#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace source_test {

using testing::ElementsAre;

TEST_F(SketchTest, TheFoldersOwnInoComesFirstThenTheOthersByName) {
  for (const char* name : {"Zebra.ino", "ant.ino", "Bee.ino", ".hidden.ino"})
    write(std::string("Zebra/") + name, "");
  EXPECT_THAT(read_sketch(folder_ / "Zebra").inos, ElementsAre("Zebra.ino", "Bee.ino", "ant.ino"));
  EXPECT_THAT(read_sketch(folder_ / "Zebra/ant.ino").inos, ElementsAre("Zebra.ino", "Bee.ino", "ant.ino"));
}

TEST_F(SketchTest, AnOnlyInoMayHaveAnyName) {
  write("download(1)/sketch_nov21a.ino", "");
  EXPECT_EQ(read_sketch(folder_ / "download(1)").name, "sketch_nov21a");
}

TEST_F(SketchTest, OneOfSeveralInosMayBeNamed) {
  write("flat/a.ino", "");
  write("flat/b.ino", "");
  write("flat/c.cpp", "");
  const Sketch sketch = read_sketch(folder_ / "flat/b.ino");
  EXPECT_EQ(sketch.name, "b");
  EXPECT_THAT(sketch.inos, ElementsAre("b.ino"));
  EXPECT_THAT(sketch.sources, ElementsAre());
}

TEST_F(SketchTest, SourcesAreThoseOfTheFolderAndAllBelowSrc) {
  for (const char* name :
       {"S.ino", "b.cpp", "a.c", "x.h", "src/deep/d.cpp", "other/no.cpp", "data/no.c", "src/y.hpp"})
    write(std::string("S/") + name, "");
  const Sketch sketch = read_sketch(folder_ / "S");
  EXPECT_THAT(sketch.sources, ElementsAre("a.c", "b.cpp", "src/deep/d.cpp"));
  EXPECT_THAT(sketch.headers, ElementsAre("src/y.hpp", "x.h"));
}

TEST_F(SketchTest, InosAreJoinedWithLineDirectivesAndUnixLineEnds) {
  write("J/J.ino", "\xEF\xBB\xBFint a;\r\nint b;");
  write("J/with \"quote\".ino", "int c;\r");
  EXPECT_EQ(join_inos(read_sketch(folder_ / "J")),
            "#line 1 \"J.ino\"\n#include <Arduino.h>\n#line 1 \"J.ino\"\nint a;\nint b;\n"
            "#line 1 \"with \\\"quote\\\".ino\"\nint c;\n");
}

TEST_F(SketchTest, TheHashOfASketchIsThatOfItsFilesByNameAndContent) {
  write("a/S/S.ino", "x");
  write("b/S/S.ino", "x");
  const std::string hash = content_sha256(read_sketch(folder_ / "a/S"));
  EXPECT_EQ(content_sha256(read_sketch(folder_ / "b/S")), hash);
  write("b/S/y.h", "");
  EXPECT_NE(content_sha256(read_sketch(folder_ / "b/S")), hash);
  write("a/S/S.ino", "z");
  EXPECT_NE(content_sha256(read_sketch(folder_ / "a/S")), hash);
}

}  // namespace source_test
}  // namespace robosim::build
