// Tests building sketches for target host: images, sources and messages.
#include <gmock/gmock.h>

#include <algorithm>

#include "sim/build/process.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace build_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::IsSubsetOf;
using testing::Not;
namespace fs = std::filesystem;

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> result;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos; at = end + 1)
    result.push_back(text.substr(at, end - at));
  return result;
}

class AnOrdinarySketch : public SketchTest, public testing::WithParamInterface<const char*> {};

TEST_P(AnOrdinarySketch, CompilesUnmodifiedAndWithoutWarnings) {
  const fs::path sketches = SKETCHES;
  Request request{sketches / GetParam(), *find_board("uno"), "host", {}, Warnings::standard};
  if (fs::exists(sketches / (std::string(GetParam()) + "_libraries")))
    request.libraries = {sketches / (std::string(GetParam()) + "_libraries")};
  const Image image = build(request);
  EXPECT_THAT(image.messages, IsEmpty());
  EXPECT_GT(image.text_bytes, 1000u);
  EXPECT_GT(image.data_bytes, 100u);
}

INSTANTIATE_TEST_SUITE_P(Sketches, AnOrdinarySketch,
                         testing::Values("CommonNames", "EepromGains", "FlashTables", "Formatting",
                                         "Hobbyist", "Order", "Parking", "PinInterrupts", "Registers",
                                         "Strings", "Tabs", "TimerInterrupt"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(SketchTest, AnImageExportsNothingButItsEntryAndNeedsLittleOfTheMachine) {
  const Image image = build({fs::path(SKETCHES) / "Formatting", *find_board("uno")});
  const std::string nm = find_program("nm").string();
  EXPECT_THAT(lines(run(Command{{nm, "-D", "-j", "--defined-only", image.image.string()}, "/", {}}).output),
              ElementsAre("robosim_image"));
  // The image may import only functions that have no state and no lock, and whose names sketches do not
  // define.
  std::vector<std::string> harmless = {"memcpy", "memmove", "memset",   "strcat", "strcpy",
                                       "strlen", "strnlen", "strfromd", "memcmp", "strstr"};
#if defined(__arm__)  // the image calls raise() for a division by zero
  harmless.emplace_back("raise");
#endif
#if defined(__arm__) || defined(__aarch64__)  // serialEvent(), a weak symbol without a definition
  harmless.emplace_back("_Z11serialEventv");
#endif
  EXPECT_THAT(
      lines(run(Command{{nm, "-D", "-j", "-u", "--without-symbol-versions", image.image.string()}, "/", {}})
                .output),
      IsSubsetOf(harmless));
}

TEST_F(SketchTest, TheLoaderRunsNoneOfItsConstructors) {
  const Image image = build({fs::path(SKETCHES) / "Hobbyist",
                             *find_board("uno"),
                             "host",
                             {fs::path(SKETCHES) / "Hobbyist_libraries"}});
  const std::string dynamic =
      run(Command{{find_program("readelf").string(), "-dSW", image.image.string()}, "/", {}}).output;
  EXPECT_THAT(dynamic, HasSubstr("robosim_init_array"));
  EXPECT_THAT(dynamic, Not(HasSubstr("(INIT")));
  EXPECT_THAT(dynamic, Not(HasSubstr("(FINI")));
}

TEST_F(SketchTest, TheSameSketchInAnotherFolderGivesTheSameImageWithoutNamesOfThisMachine) {
  const std::string code = "#include \"x.h\"\nstruct S { S() { pinMode(3, OUTPUT); } } s;\n" + kEmptySketch;
  write("a/Same/Same.ino", code);
  write("a/Same/x.h", "inline const char* where() { return __FILE__ __DATE__; }\n");
  write("a/Same/x.cpp", "#include <x.h>\nconst char* here = where();\n");
  fs::create_directories(folder_ / "b");
  fs::copy(folder_ / "a", folder_ / "b", fs::copy_options::recursive);
  const Image a = build_here("a/Same");
  const Image b = build_here("b/Same/Same.ino");
  EXPECT_FALSE(b.from_cache);
  EXPECT_EQ(a.image_sha256, b.image_sha256);
  EXPECT_EQ(a.sketch_sha256, b.sketch_sha256);
  EXPECT_EQ(sha256(read_file(a.image)), a.image_sha256);
  EXPECT_THAT(a.compiler, testing::StartsWith("gcc "));

  const std::string bytes = read_file(a.image);
  for (const std::string& name : {folder_.string(), cache_folder().string(), data_folder().string()})
    EXPECT_THAT(bytes, Not(HasSubstr(name))) << name;
}

TEST_F(SketchTest, AnotherBoardDefinesAnotherMacro) {
  write("Board/Board.ino",
        "#ifdef ARDUINO_AVR_NANO\nint nano[NUM_ANALOG_INPUTS == 8 ? 1 : -1];\n#else\nint "
        "uno[NUM_ANALOG_INPUTS == 6 ? 1 : -1];\n#endif\n" +
            kEmptySketch);
  EXPECT_FALSE(build({folder_ / "Board", *find_board("uno")}).from_cache);
  EXPECT_FALSE(build({folder_ / "Board", *find_board("nano")}).from_cache);
}

TEST_F(SketchTest, ASketchMayDefineAFunctionOfTheCoreAnew) {
  write("Own/Own.ino",
        "long map(long x, long, long, long, long) { return x; }\nvoid yield() {}\n" + kEmptySketch);
  EXPECT_FALSE(build_here("Own").from_cache);
}

TEST_F(SketchTest, GlobalsMayBeNamedLikeFunctionsOfThePcsCLibrary) {
  write("Names/Names.ino",
        "int error, index, position, stop, path, time, signal, read, write, select, link, remove, rename;\n"
        "double y0;\nlong getchar, perror, system, getenv;\n" +
            kEmptySketch);
  EXPECT_THAT(build_here("Names").messages, IsEmpty());
}

TEST_F(SketchTest, APlainCppFileIsASketchToo) {
  write("plain.cpp", "#include <Arduino.h>\n" + kEmptySketch);
  EXPECT_GT(build_here("plain.cpp").text_bytes, 1000u);
}

TEST_F(SketchTest, APathMayHoldSpacesAndSigns) {
  const std::string name = "a b=c, #1 $x/My Sketch (2)";
  write(name + "/My Sketch (2).ino", "#include \"some header.h\"\n" + kEmptySketch);
  write(name + "/some header.h", "");
  ::setenv("XDG_CACHE_HOME", (folder_ / "cache, too").c_str(), 1);
  EXPECT_FALSE(build_here(name).from_cache);
  EXPECT_TRUE(build_here(name).from_cache);
  write(name + "/some header.h", "int more;\n");
  EXPECT_FALSE(build_here(name).from_cache);
}

TEST_F(SketchTest, WarningsAreKeptWithTheImage) {
  write("Warn/Warn.ino", "void setup() {\n  int x = 1 / 0;\n}\nvoid loop() {}\n");
  const std::string messages = build_here("Warn").messages;
  EXPECT_THAT(messages, HasSubstr("Warn.ino:2:13: warning: division by zero"));
  const Image again = build_here("Warn");
  EXPECT_TRUE(again.from_cache);
  EXPECT_EQ(again.messages, messages);
  EXPECT_THAT(build({folder_ / "Warn", *find_board("uno"), "host", {}, Warnings::none}).messages, IsEmpty());
  EXPECT_THAT(build({folder_ / "Warn", *find_board("uno"), "host", {}, Warnings::all}).messages,
              HasSubstr("unused variable"));
}

TEST_F(SketchTest, ASecondBuildComesFromTheCacheUntilAFileThatWasReadChanges) {
  write("Cached/Cached.ino",
        "#include \"speed.h\"\n#include <Motor.h>\nint s = SPEED + MOTOR;\n" + kEmptySketch);
  write("Cached/speed.h", "#define SPEED 1\n");
  write("libraries/Motor/Motor.h", "#define MOTOR 1\n");
  const std::vector<fs::path> libraries = {folder_ / "libraries"};
  const Image first = build_here("Cached", libraries);
  EXPECT_THAT(first.libraries, ElementsAre("Motor"));
  const Image second = build_here("Cached", libraries);
  EXPECT_FALSE(first.from_cache);
  EXPECT_TRUE(second.from_cache);
  EXPECT_EQ(second.image, first.image);
  EXPECT_EQ(second.libraries, first.libraries);
  EXPECT_EQ(second.text_bytes, first.text_bytes);

  write("Cached/notes.txt", "not part of the sketch");
  EXPECT_TRUE(build_here("Cached", libraries).from_cache);
  for (const char* changed : {"Cached/speed.h", "libraries/Motor/Motor.h", "Cached/Cached.ino"}) {
    write(changed, read_file(folder_ / changed) + "// changed\n");
    EXPECT_FALSE(build_here("Cached", libraries).from_cache) << changed;
    EXPECT_TRUE(build_here("Cached", libraries).from_cache) << changed;
  }
  write("Cached/more.cpp", "int more;\n");
  EXPECT_FALSE(build_here("Cached", libraries).from_cache);
  write("Cached/libraries/Motor/Motor.h", "#define MOTOR 2\n");
  EXPECT_FALSE(build_here("Cached", libraries).from_cache) << "this library takes precedence";
}

TEST_F(SketchTest, AnImageThatWasDamagedInTheCacheIsMadeAnew) {
  write("Broken/Broken.ino", "int broken = 7;\n" + kEmptySketch);
  const Image first = build_here("Broken");
  fs::resize_file(first.image, 100);
  const Image second = build_here("Broken");
  EXPECT_FALSE(second.from_cache);
  EXPECT_EQ(sha256(read_file(second.image)), first.image_sha256);
}

TEST_F(SketchTest, OurOwnSketchesAreFoundByName) {
  for (const std::string& name : stock_sketches()) EXPECT_TRUE(fs::is_directory(find_sketch(name))) << name;
  EXPECT_THAT(stock_sketches(), testing::Contains("PidFollower"));
  EXPECT_THAT(
      [] { find_sketch("Nobody"); },
      testing::ThrowsMessage<InputError>(HasSubstr("'Nobody' is neither a folder here nor a sketch")));
  EXPECT_THAT([] { find_sketch("./Nobody"); }, testing::ThrowsMessage<InputError>(HasSubstr("./Nobody: ")));
  EXPECT_EQ(find_sketch(SKETCHES), fs::path(SKETCHES));
}

TEST_F(SketchTest, AHeaderThatAppearsInASubfolderIsNoticed) {
  write("S/S.ino", "#if __has_include(\"sub/x.h\")\n#error the sketch sees it\n#endif\n" + kEmptySketch);
  write("S/more.cpp", "#if __has_include(\"deep/er/y.h\")\n#error the source sees it\n#endif\n");
  EXPECT_NO_THROW(build_here("S"));
  write("S/deep/er/y.h", "");
  EXPECT_THROW(build_here("S"), CompileError);
  std::filesystem::remove_all(folder_ / "S/deep");
  EXPECT_NO_THROW(build_here("S"));
  write("S/sub/x.h", "");
  EXPECT_THROW(build_here("S"), CompileError);
}

}  // namespace build_test
}  // namespace robosim::build
