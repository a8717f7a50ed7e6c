// Tests sketch folders that try to make compilers do more than compile. The names and contents of the files
// come from the sketch's author, who may not be the user.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <thread>

#include "sim/base/child.h"
#include "sim/base/program_sandbox.h"
#include "sim/build/cache.h"
#include "sim/build/libraries.h"
#include "sim/build/narrow_ints.h"
#include "sim/build/pin_warnings.h"
#include "sim/build/process.h"
#include "sim/build/project.h"
#include "sim/build/prototypes.h"
#include "sim/build/source.h"
#include "tests/unit/build/fixture.h"

namespace robosim::build {
namespace hostile_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class HostileTest : public SketchTest {
 protected:
  void SetUp() override { write("Pupil/Pupil.ino", kEmptySketch); }

  /// Builds a sketch for target avr. Returns the error message. If the AVR compiler is missing, returns the
  /// messages that the tests expect.
  std::string error_on_avr(const std::string& name) const {
    if (!missing_tool("avr").empty()) return "begin with '@', begin with '-'";
    try {
      build({folder_ / name, *find_board("uno"), "avr"});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  /// Runs a shell script in the compiler's sandbox, with the compiler's environment. Returns the script's
  /// output.
  std::string printed_within_walls(const std::string& script) const {
    fs::create_directories(folder_ / "scratch");
    return run_within({}, {{{"/bin/sh", "-c", script}, "/", {}, folder_ / "scratch"}})[0].output;
  }
};

TEST_F(HostileTest, AFileWhoseNameCompilersTakeForAFileOfOptionsIsRefused) {
  write("Pupil/@.o.cpp", "");
  write("Pupil/.o.cpp", "-wrapper /bin/sh,evil.sh real.cpp\n");
  write("Pupil/real.cpp", "int real;\n");
  write("Pupil/evil.sh", "touch " + (folder_ / "taken").string() + "\nexec \"$@\"\n");
  const char* const sentence =
      "@.o.cpp: cannot be compiled: expected a name that does not begin with '@', which compilers read as "
      "an option; rename it";
  EXPECT_EQ(error_of("Pupil"), sentence);
}

TEST_F(HostileTest, ANameInAnyFolderAndOfAnyLanguageIsRefused) {
  for (const char* name : {"-fplugin=x.cpp", "src/@x.cpp", "src/deep/-x.c", "@x.c", "-.cc"}) {
    write(std::string("Pupil/") + name, "int x;\n");
    EXPECT_THAT(error_of("Pupil"), AllOf(StartsWith(std::string(name) + ": cannot be compiled"),
                                         HasSubstr("does not begin with")));
    fs::remove_all(folder_ / "Pupil/src");
    fs::remove(folder_ / "Pupil" / name);
  }
  write("Pupil/@dir/x.h", "");
  EXPECT_EQ(error_of("Pupil"), "no error") << "no command line contains a header";
}

TEST_F(HostileTest, ALibrarysSourcesAreNoOptionsEither) {
  write("Pupil/Pupil.ino", "#include <Thing.h>\n" + kEmptySketch);
  write("shared/Thing/Thing.h", "");
  write("shared/Thing/@Thing.cpp", "x -fplugin=/evil\n");
  EXPECT_THAT(error_of("Pupil", {folder_ / "shared"}), HasSubstr("@Thing.cpp: cannot be compiled"));
}

TEST_F(HostileTest, AnAssemblerSourceIsNoOptionEither) {
  write("Pupil/@x.S", "");
  EXPECT_THAT(error_on_avr("Pupil"), HasSubstr("begin with '@'"));
}

TEST_F(HostileTest, NoAssemblerHandsBytecodeToTheOptimiserOfTheLinker) {
  const char* const kSections =
      ".section .gnu.lto_.opts,\"e\",@progbits\n.asciz \"x\"\n.section .gnu.lto_.symtab.1,\"e\",@progbits\n"
      ".byte 0\n.comm __gnu_lto_slim,1,1\n";
  write("Pupil/x.S", kSections);
  if (missing_tool("avr").empty()) {
    EXPECT_THAT(error_on_avr("Pupil"), HasSubstr("x.S: cannot be compiled: expected no sections named"));
  }
  fs::remove(folder_ / "Pupil/x.S");
  std::string text = kSections;
  for (std::size_t at = 0; (at = text.find_first_of("\"\n", at)) != text.npos; at += 2)
    text.replace(at, 1, text[at] == '"' ? "\\\"" : "\\n");
  write("Pupil/Pupil.ino", "asm(\"" + text + ".text\");\n" + kEmptySketch);
  EXPECT_EQ(error_of("Pupil"), "no error") << "the host's linker has no such optimiser";
}

TEST_F(HostileTest, ASketchMayBeCalledLikeAnOption) {
  for (const char* name : {"@x", "-x", "x\ny", "%s", "a,b", "a=b"}) {
    write(std::string(name) + "/x.ino", kEmptySketch);
    EXPECT_EQ(error_of(name), "no error") << name;
    write(std::string(name) + "/x.elf", "x -fplugin=/evil\n");
    write(std::string(name) + "/x.elf.wpa", "x -fplugin=/evil\n");
    if (const std::string said = error_on_avr(name); missing_tool("avr").empty()) {
      EXPECT_EQ(said, "no error") << name;
    }
    write(std::string(name) + "/@ino.ino", "int x() { return 1; }\n");
    EXPECT_EQ(error_of(name), "no error") << name;
  }
}

TEST_F(HostileTest, CompilersGetNothingOfTheUsersEnvironment) {
  ::setenv("ROBOSIM_TEST_SECRET", "hunter2", 1);
  ::setenv("LD_LIBRARY_PATH", folder_.c_str(), 1);
  const std::string scratch = (folder_ / "scratch").string();
  const std::string environment = printed_within_walls("env | grep -v ^PWD= | grep -v ^_= | sort");
  ::unsetenv("ROBOSIM_TEST_SECRET");
  ::unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(environment, "CCACHE_DISABLE=1\nHOME=" + scratch + "\nLC_ALL=C\nPATH=" + ::getenv("PATH") +
                             "\nSOURCE_DATE_EPOCH=0\nTMPDIR=" + scratch + "\n");
}

TEST_F(HostileTest, AProgramInTheSketchsFolderIsNoToolOfTheCompiler) {
  write("Pupil/x.cpp", "int x;\n");
  for (const char* name : {"as", "cc1plus", "ld"}) {
    write(std::string("Pupil/") + name, "#!/bin/sh\ntouch \"$TMPDIR/taken\"\necho taken >&2\nexit 1\n");
    fs::permissions(folder_ / "Pupil" / name, fs::perms::owner_all);
  }
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", (".::" + path).c_str(), 1);
  EXPECT_EQ(error_of("Pupil"), "no error");
  EXPECT_EQ(printed_within_walls("echo $PATH"), path + "\n");
}

TEST_F(HostileTest, WhatACompilerLeavesRunningChangesNothingThatIsStored) {
  const Cache cache(folder_ / "cache");
  const fs::path made = write("made.o", "as it was");
  const Entry stored = cache.store("key", {}, read_made(made), "made.o", {}, {});
  std::ofstream(made) << "as it is now";  // simulates a program that still has the file open
  EXPECT_EQ(read_file(stored.result), "as it was");
}

TEST_F(HostileTest, ALinkInTheScratchFolderIsNoOutput) {
  const fs::path secret = write("secret.txt", "hunter2");
  fs::create_symlink(secret, folder_ / "made.o");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.o").c_str(), 0600), 0);
  for (const char* name : {"made.o", "pipe.o", "none.o"})
    EXPECT_THROW(read_made(folder_ / name), InputError) << name;
}

TEST_F(HostileTest, NoCommandWritesTheScratchFolderOfAnother) {
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  fs::create_directories(folder_ / "a");
  fs::create_directories(folder_ / "b");
  const std::string to = (folder_ / "b/x").string();
  const auto results =
      run_within({folder_ / "given"}, {{{"/bin/sh", "-c", "echo evil >" + to}, "/", {}, folder_ / "a"},
                                       {{"/bin/sh", "-c", "cat x"}, folder_ / "b", {}, folder_ / "b"}});
  EXPECT_NE(results[0].status, 0);
  EXPECT_FALSE(fs::exists(to));
}

TEST_F(HostileTest, NoCompilerChangesWhatItIsGivenFromTheCacheOrReadsMore) {
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  const Cache cache(folder_ / "cache");
  const Entry stored = cache.store("key", {}, "mine", "mine.o", {}, {});
  const Entry other = cache.store("other", {}, "another pupil's", "other.o", {}, {});
  WorkFolder work(cache);
  const std::string given = work.give(stored.result).string();
  const auto tried = [&](const std::string& script) {
    return run_within({work.given()}, {{{"/bin/sh", "-c", script}, "/", {}, work.scratch()}})[0];
  };
  EXPECT_EQ(tried("cat " + given).output, "mine");
  for (const std::string& script :
       {"echo evil >" + given, "ln " + given + " $TMPDIR/x", "mv " + given + " $TMPDIR/x", "rm " + given,
        "cat " + other.result.string(), "chmod 777 " + given + " && echo evil >>" + given})
    EXPECT_NE(tried(script).status, 0) << script;
  EXPECT_EQ(read_file(stored.result), "mine");
}

TEST_F(HostileTest, FlagsThatReadAlikeAreNotTheSameKey) {
  // Equal cache keys would also harm other sketches: all sketches share the compiled Arduino core, whose
  // cache key has the same form.
  write("Pupil/Pupil.ino",
        "#ifdef B\nint b;\n#endif\nvoid setup() {\n#ifdef B\n  B();\n#endif\n}\nvoid loop() {}\n");
  Request request{folder_ / "Pupil", *find_board("uno")};
  request.rules.flags = {"-DA=1 -DB=x"};
  const Image one = build(request);
  request.rules.flags = {"-DA=1", "-DB=x"};
  EXPECT_THROW(build(request), InputError);
  EXPECT_NE(key_of({"a b"}), key_of({"a", "b"}));
  EXPECT_NE(key_of({"a\n1 b"}), key_of({"a", "b"}));
  EXPECT_NE(key_of({"a", ""}), key_of({"a"}));
}

TEST_F(HostileTest, OutputWithoutEndIsNotReadWithoutEnd) {
  Command command{{"/bin/sh", "-c", "yes"}, "/", {}};
  command.most_output = 100'000;
  const CommandResult result = run(command);
  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.output, StartsWith(std::string(kTooMuchOutput) + "\ny\n"));
  EXPECT_LT(result.output.size(), 200'000u);
}

TEST_F(HostileTest, OutputOfManyProgramsIsLimitedTogether) {
  Command command{{"/bin/sh", "-c", "head -c 90000 /dev/zero | tr '\\0' y"}, "/", {}};
  command.most_output = 100'000;
  std::size_t total = 0;
  for (const CommandResult& result : run(std::vector<Command>(20, command))) total += result.output.size();
  EXPECT_LT(total, 200'000u);
}

TEST_F(HostileTest, ANumberInAMessageMayBeTooLargeForOne) {
  for (const char* line :
       {"#line 1 \"a\\nb.c:99999999999999999999:1: error: x\"\nint x = ;",
        "#line 1 \"a\\nb.c:1:99999999999999999999: error: x\"\nint x = ;",
        "#line 1 \"a\\nb.c:99999999999999999999:1: fatal error: y.h: No such file or directory\"\nint x = ;",
        "asm(\".error \\\"b.c:99999999999999999999: Error: x\\\"\");"}) {
    write("Pupil/Pupil.ino", std::string(line) + "\n" + kEmptySketch);
    EXPECT_NE(error_of("Pupil"), "no error") << line;  // another exception fails the test
  }
}

TEST_F(HostileTest, NoSketchMakesItselfAFaultOfTheMachine) {
  write("Pupil/Pupil.ino",
        "void f() __attribute__((error(\"No space left on device\")));\n"
        "void setup() { f(); }\nvoid loop() {}\n");
  EXPECT_THAT(error_of("Pupil"), HasSubstr("Pupil.ino:2:"));
  write("Pupil/Pupil.ino", "#include \"Too many open files.h\"\n" + kEmptySketch);
  EXPECT_THAT(error_of("Pupil"), HasSubstr("Pupil.ino:1:"));
}

/// Returns whether `work` takes at most 10 s of processor time. An algorithm of linear complexity takes about
/// 1 s.
bool ends_soon(const std::function<void()>& work) {
  return Child([&] {
           const rlimit most{10, 10};
           ::setrlimit(RLIMIT_CPU, &most);
           work();
           return 0;
         })
      .wait()
      .ok();
}

TEST_F(HostileTest, ReadersOfSourcesTakeTimeByTheirLength) {
  std::string braces = "extern int x;\nvoid f() {";
  for (int i = 0; i < 400'000; ++i) braces += "{}";
  EXPECT_TRUE(ends_soon([&] { insert_prototypes(braces, braces, {}); }));

  std::string functions, variables;
  std::vector<Tag> tags;
  for (int i = 0; i < 20'000; ++i) {
    const Tag function{
        "function" + std::to_string(i), "a.ino", i + 1, "function", "", "(int a = 0)", "int", ""};
    const Tag variable{"variable", "a.ino", i + 1, "variable", "", "", "", "int variable = 1;"};
    functions += "F(" + function.name + ") // (\n";
    tags.push_back(function);
    tags.push_back(variable);
  }
  functions = "#line 1 \"a.ino\"\n" + functions + std::string(3'000'000, ' ');
  EXPECT_TRUE(ends_soon([&] { insert_prototypes(functions, functions, tags); }));

  std::string quotes = "const char* x = R\"x( \" ";
  for (int i = 0; i < 1'000'000; ++i) quotes += "\\'";
  EXPECT_TRUE(ends_soon([&] { pin_warnings(quotes, *find_board("uno")); }));
  EXPECT_TRUE(ends_soon([&] { with_narrow_ints(quotes); }));
}

TEST_F(HostileTest, AHeaderThatIncludesItselfIsOneError) {
  write("Pupil/a.h", "#include \"a.h\"\n#include \"a.h\"\n#warning again\n");
  write("Pupil/x.cpp", "#include \"a.h\"\n");
  EXPECT_THAT(error_of("Pupil"), HasSubstr("#include nested depth"));
}

TEST_F(HostileTest, LinksThatLoopInALibraryAreTakenOnce) {
  write("Pupil/Pupil.ino", "#include <Thing.h>\n" + kEmptySketch);
  write("shared/Thing/library.properties", "name=Thing\n");
  write("shared/Thing/src/Thing.h", "");
  write("shared/Thing/src/deep/thing.cpp", "int thing;\n");
  for (const char* name : {"a", "b", "deep/c"})
    fs::create_directory_symlink(folder_ / "shared/Thing/src", folder_ / "shared/Thing/src" / name);
  fs::create_directory_symlink("..", folder_ / "shared/Thing/src/up");
  fs::create_directory_symlink("/", folder_ / "shared/Thing/src/out");
  const LibraryFinder finder({folder_ / "shared"});
  EXPECT_EQ(finder.find("Thing.h")->sources.size(), 1u);
  EXPECT_EQ(error_of("Pupil", {folder_ / "shared"}), "no error");
}

TEST_F(HostileTest, LibraryPropertiesOfManyMegabytesAreNotRead) {
  write("shared/Thing/Thing.h", "");
  const fs::path properties = write("shared/Thing/library.properties", "name=Other\n");
  EXPECT_EQ(LibraryFinder({folder_ / "shared"}).find("Thing.h")->name, "Other");
  fs::resize_file(properties, 250'000'000);
  EXPECT_EQ(LibraryFinder({folder_ / "shared"}).find("Thing.h")->name, "Thing");
}

TEST_F(HostileTest, HeadersThatIncludeEachOtherInALongChainTakeNoStack) {
  write("Pupil/Pupil.ino", "#include \"h0.h\"\n" + kEmptySketch);
  for (int i = 0; i < 3000; ++i)
    std::ofstream(folder_ / "Pupil" / ("h" + std::to_string(i) + ".h"))
        << "#include \"h" << i + 1 << ".h\"\n";
  const Sketch sketch = read_sketch(folder_ / "Pupil", {});
  const Ending ending = Child([&] {
                          const rlimit most{512 << 10, 512 << 10};
                          ::setrlimit(RLIMIT_STACK, &most);
                          return shared_files(sketch, folder_).empty() ? 0 : 1;
                        }).wait();
  EXPECT_TRUE(ending.ok()) << ending.text();
}

TEST_F(HostileTest, APrecompiledHeaderIsNotLoaded) {
  write("Pupil/Foo.h", "int foo();\n");
  write("Pupil/x.cpp", "#include \"Foo.h\"\nint x = foo();\nint foo() { return 1; }\n");
  write("Pupil/Foo.h.gch", "gpch.damaged");
  write("Pupil/first_include.h.gch", "gpch.damaged");
  EXPECT_EQ(error_of("Pupil"), "no error");
  EXPECT_EQ(error_on_avr("Pupil").substr(0, 8), missing_tool("avr").empty() ? "no error" : "begin wi");
}

TEST_F(HostileTest, AWorkingPrecompiledHeaderIsNotLoadedEither) {
  // gcc loads a precompiled header only if all options equal those that compiled the header. Here only the
  // option `-include` differs.
  const auto compiles_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {find_program("g++").string(), "-c", "-o", (folder_ / "x.o").string()};
    words.insert(words.end(), more.begin(), more.end());
    words.push_back((folder_ / "Pupil/x.cpp").string());
    return run(Command{words, folder_ / "Pupil", {}}).status == 0;
  };
  write("Pupil/Foo.h", "int hidden;\n");
  const fs::path header = folder_ / "Pupil/Foo.h";
  ASSERT_EQ(run(Command{{find_program("g++").string(), "-nostdinc", "-o", header.string() + ".gch",
                         header.string()},
                        "/",
                        {}})
                .status,
            0);
  write("Pupil/Foo.h", "#error not the precompiled one\n");
  write("Pupil/x.cpp", "#include \"Foo.h\"\nint x = hidden;\n");
  const std::string first = (data_folder() / "hal/arduino/first_include.h").string();
  EXPECT_TRUE(compiles_with({"-nostdinc"})) << "gcc uses the precompiled header";
  EXPECT_FALSE(compiles_with({"-nostdinc", "-include", first})) << "every source has this first include";
  EXPECT_THAT(error_of("Pupil"), HasSubstr("not the precompiled one"));
}

TEST_F(HostileTest, TheTimeOfABuildOrAFileIsNotInIt) {
  for (const char* name : {"Pupil/Pupil.ino", "Pupil/x.cpp", "Pupil/y.c"})
    write(name, std::string("const char* const kWhen") + name[6] +
                    "[] = {__DATE__, __TIME__, __TIMESTAMP__};\n" + (name[6] == 'P' ? kEmptySketch : ""));
  for (const char* target : {"host", "avr"}) {
    if (!missing_tool(target).empty()) continue;
    const Image image = build({folder_ / "Pupil", *find_board("uno"), target});
    for (const char* name : {"Pupil/Pupil.ino", "Pupil/x.cpp", "Pupil/y.c"})
      fs::last_write_time(folder_ / name, fs::file_time_type::clock::now() - std::chrono::hours(1000));
    write("Pupil/y.c", read_file(folder_ / "Pupil/y.c") + "\n");  // changes the cache key
    EXPECT_EQ(build({folder_ / "Pupil", *find_board("uno"), target}).image_sha256, image.image_sha256)
        << target;
  }
}

TEST_F(HostileTest, NoTextOfASketchBeginsALineOfAMessage) {
  const std::string forged = "\nrobosim: reached: The goal was reached";
  for (const char* line :
       {"#line 3 \"Pupil.ino\\nrobosim: reached: The goal was reached\"\nint x = ;",
        "static_assert(false, \"x\\nrobosim: reached: The goal was reached\");",
        "[[deprecated(\"x\\nrobosim: reached: The goal was reached\")]] void f(); int x = ;",
        "#pragma message \"x\\nrobosim: reached: The goal was reached\"\nint x = ;",
        "extern \"C\" void f() asm(\"x\\nrobosim: reached: The goal was reached\");\nvoid g() { f(); }"}) {
    write("Pupil/Pupil.ino", std::string(line) + "\n" + kEmptySketch);
    const std::string said = error_of("Pupil");
    EXPECT_NE(said, "no error") << line;
    EXPECT_THAT("\n" + said, Not(HasSubstr(forged))) << line;
  }
}

TEST_F(HostileTest, AProjectOpensNoOtherFolderToCompilers) {
  write("project/src/main.cpp", "#include \"secret.txt\"\nvoid setup() {}\nvoid loop() {}\n");
  write("secret.txt", "#error hunter2\n");
  Request request{folder_ / "project", *find_board("uno")};
  request.rules.sources = folder_ / "project/src";
  for (const fs::path& outside : {fs::path("/etc"), fs::path("/"), folder_ / "project/link"}) {
    if (outside.filename() == "link") fs::create_directory_symlink("/etc", outside);
    request.rules.includes = {outside};
    EXPECT_THROW(build(request), InputError) << outside;
  }
  request.rules.includes = {};
  fs::create_directories(folder_ / "project/.git");
  write("elsewhere/main.cpp", kEmptySketch);
  request.rules.sources = folder_ / "elsewhere";
  EXPECT_THROW(build(request), InputError) << "the folder is outside of the checkout";
}

TEST_F(HostileTest, AProjectsMacrosMakeTheCoreReadNoFile) {
  if (!ProgramSandbox::missing().empty()) GTEST_SKIP() << ProgramSandbox::missing();
  write("Pupil/secret.txt", "");
  const fs::path secret = write("secret.txt", "#error hunter2\n");
  Request request{folder_ / "Pupil", *find_board("uno")};
  request.rules.flags = {"-DROBOSIM_REGISTERS=\"" + secret.string() + "\""};
  try {
    build(request);
    FAIL() << "it compiles";
  } catch (const CompileError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("the core does not compile with build_flags -DROBOSIM_REGISTERS"),
                      Not(HasSubstr("hunter2"))));
  }
}

TEST_F(HostileTest, ProgramsThatRunAtTheSameTimeShareTheMemory) {
  const auto limits = [&](std::size_t count) {
    std::vector<Command> commands;
    for (std::size_t i = 0; i < count; ++i) {
      const fs::path scratch = folder_ / std::to_string(i);
      fs::create_directories(scratch);
      commands.push_back({{"/bin/sh", "-c", "ulimit -d"}, "/", {}, scratch});
    }
    unsigned long kilobytes = 0;
    const std::size_t at_once =
        std::min<std::size_t>(count, std::clamp(std::thread::hardware_concurrency(), 1u, 4u));
    for (const CommandResult& result : run_within({}, commands)) kilobytes += std::stoul(result.output);
    return kilobytes / count * at_once;
  };
  for (const std::size_t count : {1, 2, 8}) EXPECT_EQ(limits(count), kCompileBytes >> 10) << count;
}

TEST_F(HostileTest, AProgramThatNeedsMoreThanItsShareRunsAgainAlone) {
  const std::string needs_all =
      "test $(ulimit -d) -ge 200000 || { echo virtual memory exhausted; exit 1; }; echo enough";
  std::vector<Command> commands;
  for (const char* name : {"a", "b", "c"}) {
    fs::create_directories(folder_ / name);
    commands.push_back({{"/bin/sh", "-c", needs_all}, "/", {}, folder_ / name});
  }
  for (const CommandResult& result : run_within({}, commands)) EXPECT_EQ(result.output, "enough\n");
}

TEST_F(HostileTest, AfterAProgramThatWorksWithoutEndNoOtherIsStarted) {
  std::vector<Command> commands;
  for (int i = 0; i < 20; ++i) {
    const fs::path scratch = folder_ / std::to_string(i);
    fs::create_directories(scratch);
    commands.push_back(
        {{"/bin/sh", "-c", "echo >made; echo CPU time limit exceeded; exit 1"}, scratch, {}, scratch});
  }
  const auto results = run_within({}, commands);
  EXPECT_LE(std::count_if(commands.begin(), commands.end(),
                          [](const Command& one) { return fs::exists(one.scratch / "made"); }),
            8);
  for (const CommandResult& result : results) EXPECT_NE(result.status, 0);
}

TEST_F(HostileTest, AProgramThatWaitsForAPipeIsEnded) {
  fs::create_directories(folder_ / "scratch");
  ASSERT_EQ(::mkfifo((folder_ / "scratch/pipe").c_str(), 0600), 0);
  Command command{{"/bin/sh", "-c", "cat pipe; true"}, folder_ / "scratch", {}, folder_ / "scratch"};
  command.most_wait_s = 1;
  const CommandResult result = run_within({}, {command})[0];
  EXPECT_NE(result.status, 0);
  EXPECT_EQ(result.output, std::string(kWaits) + "\n");
}

TEST_F(HostileTest, NoProgramThatAnEndedOneHasStartedGoesOn) {
  Command command{{"/bin/sh", "-c", "sleep 1000 & echo $!; yes"}, "/", {}};
  command.most_output = 100'000;
  const std::string output = run(command).output;
  const std::string started = output.substr(output.find('\n') + 1);
  const Descriptor process(static_cast<int>(::syscall(SYS_pidfd_open, std::stoi(started), 0)));
  pollfd ended{process.get(), POLLIN, 0};
  EXPECT_TRUE(!process.is_open() || ::poll(&ended, 1, 30'000) == 1) << "the process ends soon";
}

TEST_F(HostileTest, NoSourceIsALinkOutOfTheProject) {
  write("project/Pupil/Pupil.ino", kEmptySketch);
  write("secret.txt", "#error hunter2\n");
  write("project/common/common.h", "");
  for (const char* name : {"other.ino", "x.cpp", "src/x.c"}) {
    fs::create_directories(folder_ / "project/Pupil/src");
    const fs::path link = folder_ / "project/Pupil" / name;
    fs::create_symlink(folder_ / "secret.txt", link);
    EXPECT_THAT(error_of("project/Pupil"),
                AllOf(HasSubstr(": a link to "), HasSubstr("outside of the sketch's project"),
                      Not(HasSubstr("hunter2"))))
        << name;
    fs::remove(link);
  }
  fs::create_symlink("../common/common.h", folder_ / "project/Pupil/common.h");
  EXPECT_EQ(error_of("project/Pupil"), "no error");
}

TEST_F(HostileTest, ASketchOfManyMegabytesIsRefused) {
  const auto refusal = [](int megabytes) {
    return HasSubstr(
        fmt::format("is too large: expected sources of at most 2 MB together, got {} MB", megabytes));
  };
  for (const char* name : {"Pupil/big.h", "Pupil/big.cpp", "Pupil/src/big.c"}) {
    write(name, "");
    fs::resize_file(folder_ / name, 100'000'000);
    EXPECT_THAT(error_of("Pupil"), refusal(96));
    fs::resize_file(folder_ / name, 2 << 20);
    EXPECT_THAT(error_of("Pupil"), refusal(3)) << "a part of a megabyte counts as one";
    fs::remove(folder_ / name);
  }
}

TEST_F(HostileTest, RepeatedWordsAreCheckedInLinearTime) {
  const auto repeated = [](const char* word, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += word;
    return text;
  };
  for (const std::string& words : {repeated("const ", 200'000), "int x " + repeated("* ", 200'000)}) {
    write("Pupil/Pupil.ino", words + "\n" + kEmptySketch);
    EXPECT_NE(error_of("Pupil"), "no error");
  }
}

TEST_F(HostileTest, AMessageThatEndsBeforeItsOptionIsStillShown) {
  if (!missing_tool("host").empty()) GTEST_SKIP() << missing_tool("host");
  write("Pupil/Pupil.ino", "#if __SIZEOF_INT__ == 2\n#warning x[-Woverflow]" + std::string(2100, 'y') +
                               "\n#endif\n" + kEmptySketch);
  EXPECT_EQ(error_of("Pupil"), "no error");
}

TEST_F(HostileTest, ACompilerThatMakesALargeFileIsTheSketchsFault) {
  if (!missing_tool("host").empty()) GTEST_SKIP() << missing_tool("host");
  write("Pupil/Pupil.ino", "asm(\".data\\n.fill 100000000, 1, 1\\n.text\");\n" + kEmptySketch);
  EXPECT_THAT(error_of("Pupil"), HasSubstr("it wrote a file of more than 32 MB"));
}

TEST_F(HostileTest, ASketchThatTakesDownCtagsIsAnErrorOfThatSketch) {
  write("bin/arduino-ctags", "#!/bin/sh\nkill -11 $$\n");
  fs::permissions(folder_ / "bin/arduino-ctags", fs::perms::owner_all);
  const std::string path = ::getenv("PATH");
  ::setenv("PATH", ((folder_ / "bin").string() + ":" + path).c_str(), 1);
  EXPECT_THROW(build({folder_ / "Pupil", *find_board("uno")}), CompileError);
  ::setenv("PATH", path.c_str(), 1);
}

TEST_F(HostileTest, HeadersThatIncludeManyNamesTakeLittleMemory) {
  write("Pupil/Pupil.ino", "#include \"a.h\"\n#include \"b.h\"\n" + kEmptySketch);
  std::string names;
  for (int i = 0; i < 75'000; ++i) names += "#include \"x\"\n";
  for (const char* name : {"Pupil/a.h", "Pupil/b.h"}) write(name, names);
  const Sketch sketch = read_sketch(folder_ / "Pupil", {});
  const Ending ending = Child([&] {
                          const rlimit most{32 << 20, 32 << 20};
                          ::setrlimit(RLIMIT_DATA, &most);
                          return shared_files(sketch, folder_).empty() ? 0 : 1;
                        }).wait();
  EXPECT_TRUE(ending.ok()) << ending.text();
}

}  // namespace hostile_test
}  // namespace robosim::build
