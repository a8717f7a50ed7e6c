// Generates hostile folders of sketches: odd names, links, special files, huge files, project files,
// includes, assembly code and libraries. Other inputs exhaust the compiler, forge its messages, or are
// hostile map and robot files.
#include <fmt/format.h>

#include <utility>

#include "tests/hostile/input.h"

namespace robosim::hostile {
namespace {

using Entries = std::vector<Entry>;

const std::string kBody = "void setup() {}\nvoid loop() { delay(1); }\n";
const std::string kS = kSecretHere;

/// Returns a short code for a text that is repeated `times` times. When a file is written, written_out()
/// expands the code. The expanded texts of all inputs together would need too much memory.
std::string repeated(const std::string& text, int times) {
  return fmt::format("\x02{}\x03{}\x04", times, text);
}

Entry file(const std::string& path, const std::string& content) { return {path, content}; }
Entry link(const std::string& path, const std::string& to) { return {path, to, Kind::link}; }
Entry ino(const std::string& before) { return file("S.ino", before + "\n" + kBody); }
/// Returns a folder with this source, and nothing else that is hostile.
Entries source(const std::string& text) { return {ino(text)}; }

class Folders {
 public:
  void add(const std::string& mechanism, const std::string& variant, Entries entries,
           Target target = Target::both) {
    all_.push_back({mechanism, variant, std::move(entries), target});
  }
  void add_names();
  void add_links();
  void add_special_files();
  void add_large_files();
  void add_precompiled_headers();
  void add_projects();
  void add_includes();
  void add_assembly();
  void add_bombs();
  void add_messages();
  void add_libraries();
  void add_data();
  std::vector<Input> take() { return std::move(all_); }

 private:
  std::vector<Input> all_;
};

// One line for each input.
// clang-format off
void Folders::add_names() {
  const std::pair<const char*, std::string> names[] = {
      {"options_file", "@x"}, {"option", "-fplugin=x"}, {"output", "-o"}, {"newline", "x\ny"}, {"tab", "x\ty"},
      {"escape", "x\033[2Jy"}, {"blank", " x "}, {"quotes", "x\"y'z"}, {"backslash", "x\\y"},
      {"shell", "$(touch x);`id`"}, {"format", "%s%n{}"}, {"pattern", "*?[x]"}, {"assignment", "a=b,c:d"},
      {"comment", "x#y"}, {"right_to_left", "x\xe2\x80\xaey"}, {"bad_utf8", "x\xff\xfey"}, {"return", "x\ry"},
      {"composed", "e\xcc\x81"}, {"long", std::string(240, 'x')}, {"question_marks", "x?\?/y"},
      {"line_end_backslash", "x\\\ny"}, {"dots", "..x"}};
  for (const auto& [variant, name] : names) {
    add("name_of_a_source", variant, {ino(""), file(name + ".cpp", "int x_y;\n"), file(".o.cpp", "-wrapper /bin/false\n")});
    add("name_of_a_header", variant, {ino(""), file("a.cpp", "#include \"" + name + ".h\"\n"), file(name + ".h", "#error\n")});
    add("name_of_a_folder", variant, {ino(""), file("src/" + name + "/x.c", "int x_y;\n"), file(name + "/" + name + ".h", "")});
    add("name_of_a_sketch", variant, {file("S.ino", kBody), file(name + ".ino", "int own;\n")});
  }
  std::string deep = "src/";
  for (int i = 0; i < 40; ++i) deep += std::string(90, 'd') + "/";
  add("name_of_a_folder", "as_long_as_a_path_may_be", {ino(""), file(deep + "x.c", "int x_y;\n")});
}

void Folders::add_links() {
  const std::pair<const char*, std::string> targets[] = {
      {"secret", kS}, {"passwd", "/etc/passwd"}, {"environment", "/proc/self/environ"}, {"memory", "/proc/self/mem"},
      {"zero", "/dev/zero"}, {"input", "/dev/stdin"}, {"descriptor", "/proc/self/fd/3"}, {"dangling", "nowhere"},
      {"itself", "."}, {"root", "/"}, {"neighbour", "../neighbour"}};
  for (const auto& [variant, to] : targets) {
    add("link_as_sketch", variant, {link("S.ino", to)});
    add("link_as_header", variant, {ino("#include \"h.h\""), link("h.h", to)});
    add("link_as_source", variant, {ino(""), link("x.cpp", to)});
    add("link_as_folder", variant, {ino("#include <L.h>"), link("src", to), link("libraries", to), link("L", to)});
    add("link_as_settings", variant, {ino(""), link("platformio.ini", to), link("checks.toml", to), link("robot.toml", to), link("sketch.yaml", to), link("one.map", to)});
  }
  add("links_that_loop", "two", {ino(""), link("src/a", "b"), link("src/b", "a")});
  add("links_that_loop", "sketch", {link("S.ino", "S.ino")});
  add("links_that_loop", "folders", {ino("#include <L.h>"), file("libraries/L/library.properties", "name=L\n"), file("libraries/L/src/L.h", ""), link("libraries/L/src/a", "."), link("libraries/L/src/b", "."), link("libraries/L/src/c", "..")});
  add("links_that_loop", "sources", {ino(""), file("src/x.c", ""), link("src/a", "."), link("src/b", "..")});
  add("hard_link", "header", {ino("#include \"h.h\""), {"h.h", "S.ino", Kind::hard_link}});
}

void Folders::add_special_files() {
  for (const auto& [variant, kind] : {std::pair<const char*, Kind>{"pipe", Kind::pipe}, {"socket", Kind::socket},
                                      {"device", Kind::device}, {"folder", Kind::folder}}) {
    add("special_sketch", variant, {{"S.ino", "", kind}});
    add("special_source", variant, {ino(""), {"x.cpp", "", kind}, {"src/y.c", "", kind}, {"z.S", "", kind}});
    add("special_header", variant, {ino("#include \"h.h\""), {"h.h", "", kind}});
    add("special_settings", variant, {ino(""), {"platformio.ini", "", kind}, {"checks.toml", "", kind}, {"sketch.yaml", "", kind}});
    add("special_robot_and_map", variant, {ino(""), {"robot.toml", "", kind}, {"one.map", "", kind}});
    add("special_library", variant, {ino("#include <L.h>"), file("libraries/L/L.h", ""), {"libraries/L/library.properties", "", kind}, {"libraries/L/x.cpp", "", kind}});
    add("special_precompiled_header", variant, {ino("#include \"h.h\""), file("h.h", ""), {"h.h.gch", "", kind}});
  }
}

void Folders::add_large_files() {
  const auto sparse = [](const std::string& path, const char* bytes) { return Entry{path, bytes, Kind::sparse}; };
  for (const char* bytes : {"100000000", "250000000", "3000000000"})
    for (const char* path : {"S.ino", "x.cpp", "h.h", "platformio.ini", "checks.toml", "sketch.yaml", "robot.toml", "one.map", "libraries/L/library.properties", "libraries/L/x.cpp", "h.h.gch", "arduino_secrets.h"})
      add(std::string("large_") + path, bytes, std::string(path) == "S.ino" ? Entries{sparse(path, bytes)} : Entries{ino("#if __has_include(\"h.h\")\n#include \"h.h\"\n#endif\n#if __has_include(<L.h>)\n#include <L.h>\n#endif"), file("libraries/L/L.h", ""), sparse(path, bytes)});
  Entries headers = {ino("")}, sources = {ino("")};
  for (int i = 0; i < 20; ++i) headers.push_back(sparse(fmt::format("h{}.h", i), "200000000"));
  for (int i = 0; i < 20; ++i) sources.push_back(sparse(fmt::format("s{}.c", i), "50000000"));
  add("large_h.h", "twenty", headers);
  add("large_x.cpp", "twenty", sources);
}

void Folders::add_precompiled_headers() {
  for (const char* of : {"h.h", "Arduino.h", "first_include.h", "S.ino", "stdint.h"})
    add("precompiled_header", of, {ino("#include \"h.h\"\n#include <stdint.h>"), file("h.h", ""), file(of + std::string(".gch"), "gpch.014" + std::string(4096, '\1'))});
  add("precompiled_header", "folder", {ino("#include \"h.h\""), file("h.h", ""), file("h.h.gch/x", "gpch.014")});
  add("precompiled_header", "modules", {file("S.ino", "#pragma GCC pch_preprocess \"" + kS + "\"\n" + kBody), file("gcm.cache/x.gcm", "ELF"), file("module.modulemap", "module x {}\n")});
}

void Folders::add_projects() {
  const std::pair<const char*, std::string> lines[] = {
      {"include_folder", "build_flags = -I/etc"}, {"include_file", "build_flags = -include " + kS}, {"plugin", "build_flags = -fplugin=./x.so"},
      {"tools", "build_flags = -B."}, {"specs", "build_flags = -specs=x.specs"}, {"wrapper", "build_flags = -wrapper /bin/sh,x"},
      {"quotes", "build_flags = -DX=\"a b'c\\\"d\" -D'Y=1 -o z'"}, {"linker", "build_flags = -Wl,-T," + kS}, {"assembler", "build_flags = -Wa,@" + kS},
      {"options_file", "build_flags = @x"}, {"output", "build_flags = -o x"}, {"language", "build_flags = -x c"}, {"dependencies", "build_flags = -MD -MF x"},
      {"temporary_files", "build_flags = -save-temps -fdump-tree-all"}, {"folders", "build_flags = -iquote/etc -idirafter/etc --sysroot=/etc -L/etc"},
      {"split_option", "build_flags = -D\n  X\n  -include\n  " + kS}, {"macro_of_the_core", "build_flags = -DROBOSIM_REGISTERS=\"" + kS + "\" -DArduino_h"},
      {"macro_with_a_newline", "build_flags = -DX=1\\\n#include"}, {"unset", "build_flags = -UARDUINO -U__AVR__ -DF_CPU=0"}, {"command", "build_flags = !touch x"},
      {"environment", "build_flags = -DX=${sysenv.HOSTILE_SECRET}"}, {"unflags", "build_unflags = -Os -c"}, {"sources", "[platformio]\nsrc_dir = /etc"},
      {"sources_above", "[platformio]\nsrc_dir = ../../outside"}, {"headers", "[platformio]\ninclude_dir = /etc"}, {"libraries", "lib_extra_dirs = /etc\n  ../../outside"},
      {"dependency", "lib_deps = file://" + kS + "\n  https://127.0.0.1:@PORT@/x.zip"}, {"scripts", "extra_scripts = pre:x.py"}, {"board", "board = ../../outside/secret"},
      {"inheritance", "extends = env:uno\n[env:a]\nextends = env:b\n[env:b]\nextends = env:a"}, {"interpolation", "x = ${env:uno.x}${env:uno.x}\nbuild_flags = ${env:uno.x}"},
      {"data", "[platformio]\nextra_configs = " + kS + "\ndata_dir = /etc"}, {"source_filter", "build_src_filter = +</etc/*> +<../../outside>"}, {"core", "platform_packages = framework-arduino-avr@file:///etc"}};
  for (const auto& [variant, line] : lines)
    add("platformio", variant, {file("platformio.ini", "[env:uno]\nplatform = atmelavr\nboard = uno\n" + line + "\n"), file("src/main.cpp", "#include <Arduino.h>\n" + kBody), file("src/x", "-include " + kS + "\n"), file("x", "-include " + kS + "\n"), file("x.py", "open('x','w')\n")});
  for (const auto& [variant, text] : {std::pair<const char*, std::string>{"long_line", "build_flags = " + repeated("-DX ", 300'000)}, {"many_sections", repeated("[env:x]\nboard = uno\n", 50'000)}, {"many_folders", "lib_extra_dirs =" + repeated(" .", 100'000)}})
    add("platformio_bomb", variant, {file("platformio.ini", "[env:uno]\nboard = uno\n" + text + "\n"), file("src/main.cpp", "#include <Arduino.h>\n" + kBody)});
}

void Folders::add_includes() {
  const std::string any[] = {kS, "../../outside/secret.h", "/etc/passwd", "/proc/self/environ", "/proc/self/cmdline", "/dev/zero",
                             "/dev/stdin", "/dev/tty", "/proc/self/fd/0", "/proc/1/environ", "/", "../neighbour/../../outside/secret.h"};
  int number = 0;
  for (const std::string& path : any) {
    const std::string name = fmt::format("{}", number++);
    add("include", name, source("#include \"" + path + "\""));
    add("include_below_src", name, {ino(""), file("src/x.c", "#include \"" + path + "\"\n")});
    if (number > 6) continue;
    add("include_in_angles", name, source("#include <" + path + ">"));
    add("include_by_macro", name, source("#define STR(x) #x\n#define X(x) STR(x)\n#include X(" + path + ")"));
    add("has_include", name, source("#if __has_include(\"" + path + "\")\n#error FOUND\n#endif"));
    add("include_next", name, source("#include_next \"" + path + "\"\n#import \"" + path + "\""));
    add("pragma_dependency", name, source("#pragma GCC dependency \"" + path + "\" hunter"));
    add("embed", name, source("const unsigned char x[] = {\n#embed \"" + path + "\"\n};"));
    add("incbin", name, source("asm(\".incbin \\\"" + path + "\\\"\");"));
    add("asm_include", name, source("asm(\".include \\\"" + path + "\\\"\");"));
    add("line_of_a_file", name, source("#line 1 \"" + path + "\"\n#error shown\nint x = ;"));
    add("asm_file", name, {ino(""), file("x.S", ".incbin \"" + path + "\"\n.include \"" + path + "\"\n")}, Target::avr);
  }
}

void Folders::add_assembly() {
  const std::pair<const char*, std::string> lines[] = {
      {"fill", ".fill 0x7fffffff, 8, 1"}, {"zero", ".zero 0x100000000"}, {"space_of_a_gigabyte", ".data\\n.skip 1000000000, 1\\n.text"}, {"origin", ".org 0x7fffffff"},
      {"repeat", ".rept 100000\\n.rept 100000\\nnop\\n.endr\\n.endr"}, {"macro_without_end", ".macro m\\nm\\nm\\n.endm\\nm"}, {"deep_conditions", ".rept 100000\\n.if 1\\n.endr"},
      {"alignment", ".p2align 30"}, {"print", ".print \\\"FORGED: x\\\"\\n.warning \\\"\\\\nFORGED: x\\\"\\n.error \\\"FORGED\\\""}, {"file", ".file 9 \\\"" + kS + "\\\"\\n.loc 9 1"},
      {"linker_warning", ".pushsection .gnu.warning.setup, \\\"a\\\"\\n.string \\\"\\\\nFORGED: x\\\\033[2J\\\"\\n.popsection"}, {"interpreter", ".pushsection .interp,\\\"a\\\"\\n.string \\\"/bin/sh\\\"\\n.popsection"},
      {"libraries", ".pushsection .deplibs,\\\"MS\\\",@llvm_dependent_libraries,1\\n.string \\\"" + kS + "\\\"\\n.popsection"}, {"junk_lto", ".pushsection .gnu.lto_.x,\\\"\\\"\\n.string \\\"junk\\\"\\n.popsection"},
      {"junk_debug", ".pushsection .debug_info,\\\"\\\"\\n.long 99999999, 0x41414141\\n.popsection"}, {"junk_notes", ".pushsection .note.gnu.property,\\\"a\\\"\\n.long 4, 0x7fffffff, 5\\n.string \\\"GNU\\\"\\n.popsection"},
      {"link_once", ".section .gnu.linkonce.t.setup,\\\"axG\\\",@progbits,setup,comdat\\n.text"}, {"symbol_version", ".symver setup, setup@@FORGED_1"}, {"symbol_with_a_newline", ".globl \\\"x\\\\nFORGED: y\\\"\\ncall \\\"x\\\\nFORGED: y\\\""},
      {"long_symbol", ".globl " + std::string(100'000, 'x')}, {"absolute", ".globl loop\\n.set loop, 0x7fffffff"}, {"group", ".section .x,\\\"aG\\\",@progbits,x\\n.text"}, {"weak_alias", ".weak malloc\\n.set malloc, setup"},
      {"comment_of_the_compiler", "# 1 \\\"" + kS + "\\\"\\n#APP\\n#NO_APP"}, {"huge_section_count", ".altmacro\\n.macro s n\\n.section .s\\\\n\\n.endm\\n.set i,0\\n.rept 70000\\ns %i\\n.set i,i+1\\n.endr\\n.text"}};
  for (const auto& [variant, line] : lines) add("assembly", variant, source("asm(\"" + line + "\");"));
  add("assembly", "operand", source("void f() { asm volatile(\"%0 %1 %9\" :: \"X\"(1), \"m\"(*(char*)0)); }"));
  add("linker", "script_as_a_source", {ino(""), file("x.ld", "INPUT(" + kS + ")\n"), file("sections.ld", "SECTIONS {}\n"), file("exports.map", "{ global: *; };\n")});
  add("linker", "object_as_a_source", {ino(""), file("x.o", "\x7f" "ELF"), file("x.a", "!<arch>\n"), file("libm.so", "INPUT(" + kS + ")\n"), file("libc.so.6", "INPUT(" + kS + ")\n")});
  add("linker", "no_setup", {file("S.ino", "#define setup other\n" + kBody)});
  add("linker", "undefined_with_escapes", source("void f() asm(\"\\x1b[2J\\nFORGED: x\"); struct C { C() { f(); } } c;"));
  add("linker", "many_undefined", source("#define A(n) void u##n(); struct C##n { C##n() { u##n(); } } c##n;\n#define B(n) A(n##0) A(n##1) A(n##2) A(n##3) A(n##4) A(n##5) A(n##6) A(n##7)\n#define C(n) B(n##0) B(n##1) B(n##2) B(n##3) B(n##4) B(n##5)\nC(1) C(2) C(3) C(4) C(5) C(6)"));
  add("linker", "duplicates", {ino("int same;"), file("x.cpp", "int same; void setup() {} void loop() {}\n")});
}

void Folders::add_bombs() {
  std::string doubling = "#define M0 x\n";
  for (int i = 1; i < 40; ++i) doubling += fmt::format("#define M{} M{} M{}\n", i, i - 1, i - 1);
  const std::pair<const char*, std::string> sources[] = {
      {"macros", doubling + "int M39;"}, {"macro_text", doubling + "#define S(x) #x\n#define T(x) S(x)\nconst char* t = T(M39);"}, {"macro_condition", doubling + "#if M39\n#endif"},
      {"constexpr_loop", "constexpr long f() { long n = 0; while (n < 1l << 62) ++n; return n; }\nconstexpr long x = f();"},
      {"constexpr_calls", "constexpr long f(int n) { return n < 2 ? n : f(n - 1) + f(n - 2) + f(n - 3); }\nconstexpr long x = f(500);"},
      {"constexpr_memory", "struct A { int a[1 << 28]; constexpr A() : a() { for (int& x : a) x = 1; } };\nconstexpr A x;"},
      {"templates", "template <int N> struct F { static const long v = F<N - 1>::v + F<N - 2>::v; };\nlong x = F<1 << 30>::v;"},
      {"templates_by_two", "template <int N, int M> struct F { typename F<N - 1, 2 * M>::T a; typename F<N - 1, 2 * M + 1>::T b; typedef F T; };\ntemplate <int M> struct F<0, M> { typedef int T; };\nF<24, 1> x;"},
      {"template_names", "template <class A, class B> struct P {};\ntemplate <int N> struct G { typedef P<typename G<N - 1>::T, typename G<N - 1>::T> T; };\ntemplate <> struct G<0> { typedef int T; };\nvoid f(G<28>::T*) {}"},
      {"pack", "template <int... N> struct S {};\ntemplate <class T> struct D;\ntemplate <int... N> struct D<S<N...>> { typedef S<N..., N...> T; };\ntemplate <int N> struct E { typedef typename D<typename E<N - 1>::T>::T T; };\ntemplate <> struct E<0> { typedef S<1> T; };\nE<27>::T x;"},
      {"parentheses", "int x = " + repeated("(", 200'000) + "1" + repeated(")", 200'000) + ";"},
      {"operators", "int x = " + repeated("-~", 200'000) + "1;"}, {"additions", "int y; int x = y" + repeated("+y", 200'000) + ";"},
      {"blocks", "void f() " + repeated("{", 100'000) + repeated("}", 100'000)}, {"conditions", repeated("#if 1\n", 100'000) + repeated("#endif\n", 100'000)},
      {"namespaces", repeated("namespace n {", 20'000) + repeated("}", 20'000)}, {"pointers", "int " + repeated("*", 200'000) + "x;"}, {"initialisers", "int x[] = {" + repeated("{", 20'000) + "1" + repeated("}", 20'000) + "};"},
      {"numbers", "long x[] = {" + repeated("1234567,", 1'000'000) + "};"}, {"declarations", repeated("extern int x;\n", 1'000'000)}, {"cases", "int f(int n) { switch (n) {\n" + repeated("case __COUNTER__: n += n * __COUNTER__;\n", 20'000) + "} return n; }"},
      {"functions", "#define F(n) int f##n(int a) { return a * n; }\n#define G(n) F(n##0) F(n##1) F(n##2) F(n##3) F(n##4) F(n##5) F(n##6) F(n##7) F(n##8) F(n##9)\n#define H(n) G(n##0) G(n##1) G(n##2) G(n##3) G(n##4) G(n##5) G(n##6) G(n##7) G(n##8) G(n##9)\n#define I(n) H(n##0) H(n##1) H(n##2) H(n##3) H(n##4) H(n##5) H(n##6) H(n##7) H(n##8) H(n##9)\nI(1) I(2) I(3) I(4) I(5)"},
      {"text", "const char x[] = \"" + repeated("x", 8 << 20) + "\";"}, {"blanks", repeated(" ", 64 << 20)}, {"lines", repeated("\n", 16 << 20)}, {"zeros", repeated(std::string(1, 0), 1 << 20)},
      {"comment", "/*" + repeated("x", 32 << 20)}, {"continued_lines", "#define X " + repeated("x \\\n", 1'000'000)}, {"raw_text", "const char x[] = R\"(" + repeated("\n", 16 << 20)},
      {"long_name", "int " + repeated("x", 4 << 20) + ";"}, {"bad_utf8", "int x\xff\xc0\x80;"}, {"utf16", std::string("\xff\xfei\0n\0t\0 \0x\0;\0", 14)}, {"variables", "char x[1l << 40];"}, {"frame", "int f() { volatile char x[1l << 35]; return x[7]; }"},
      {"initialised_variables", "char x[300000000] = {1};"}, {"vectors", "typedef int V __attribute__((vector_size(1 << 28))); V f(V a, V b) { return a * b; }"}, {"labels", "void f(int n) { L: " + repeated("if (n--) goto L;", 50'000) + "}"},
      {"attributes", "void f() __attribute__((" + repeated("unused,", 500'000) + "unused));"}, {"lambdas", "int x = " + repeated("[](){return ", 800) + "1" + repeated(";}()", 800) + ";"}, {"inlining", "#define A inline __attribute__((always_inline)) int\nA f0(int n) { return n * n + 1; }\n#define F(a, b) A a(int n) { return b(n) * b(n + 1) + b(n - 1) * b(n + 2); }\nF(f1, f0) F(f2, f1) F(f3, f2) F(f4, f3) F(f5, f4) F(f6, f5) F(f7, f6) F(f8, f7) F(f9, f8)\nint x = f9(1);"},
      {"unbalanced_quotes", "#if 0\n" + repeated("\"'\n", 300'000) + "#endif"}, {"prototypes", repeated("int f(int a, char* b = \"(\") { return 1; }\n", 3000)}, {"errors", repeated("int x = ;\n", 200'000)}, {"error_of_a_long_line", "#error " + repeated("x", 8 << 20)},
      {"long_expression_in_an_error", "int x = f(" + repeated("a+", 100'000) + "1);"}, {"errors_in_templates", "template <int N> struct F : F<N - 1> { typedef typename F<N - 1>::nothing T; };\ntemplate <> struct F<0> {};\nF<800>::T x;"}};
  for (const auto& [variant, text] : sources) add("bomb", variant, source(text));
  add("include_bomb", "itself", {ino("#include \"a.h\""), file("a.h", "#include \"a.h\"\n#include \"a.h\"\n#warning again\n")});
  add("include_bomb", "sketch", source("#include \"S.ino\"\n#include __FILE__"));
  add("include_bomb", "wide", {ino("#include \"a.h\""), file("a.h", repeated("#include \"b.h\"\n", 1000)), file("b.h", repeated("#include \"c.h\"\n", 1000)), file("c.h", repeated("extern int x;\n", 100))});
  add("include_bomb", "counted", {ino("#define N 0\n#include \"a.h\""), file("a.h", "#if __INCLUDE_LEVEL__ < 190\n#include \"a.h\"\n#include \"a.h\"\n#endif\n")});
  const auto many = [](const char* name, const char* content, int count) {
    Entries entries;
    for (int i = 0; i < count; ++i) entries.push_back(file(fmt::format(fmt::runtime(name), i), fmt::format(fmt::runtime(content), i + 1)));
    return entries;
  };
  const auto with = [](Entry first, Entries entries) {
    entries.insert(entries.begin(), std::move(first));
    return entries;
  };
  add("many_files", "headers_in_a_chain", with(ino("#include \"h0.h\""), many("h{}.h", "#include \"h{}.h\"\n", 3000)));
  add("many_files", "sources", with(ino(""), many("s{}.c", "int s{};\n", 300)));
  add("many_files", "sources_that_are_bombs", with(ino(""), many("s{}.cpp", "constexpr long f(int n) {{ return n < 2 ? n : f(n - 1) + f(n - 2) + f(n - {}); }}\nconstexpr long x = f(500);\n", 40)));
  add("many_files", "sources_that_need_memory", with(ino(""), many("s{}.cpp", "template <int N, int M> struct F {{ typename F<N - 1, 2 * M>::T a; typename F<N - 1, 2 * M + 1>::T b; typedef F T; }};\ntemplate <int M> struct F<0, M> {{ typedef int T; }};\nF<24, {}> x;\n", 8)));
  add("many_files", "sketches", with(ino(""), many("t{}.ino", "int t{};\n", 3000)));
  add("many_files", "libraries", with(ino("#include <Nowhere.h>"), many("libraries/L{}/L.h", "// {}\n", 5000)));
  add("many_files", "libraries_in_a_chain", with(ino("#include <L0.h>"), many("libraries/L{0}/L{0}.h", "#include <L{}.h>\n", 60)));
  add("many_files", "names_that_are_not_sources", with(ino(""), many("data/{}.txt", "{}", 20'000)));
  Entries deep = {ino("")};
  std::string below = "src";
  for (int i = 0; i < 900; ++i) below += "/d";  // create_directories() refuses more than 1000
  deep.push_back(file(below + "/x.c", "int x_y;\n"));
  add("many_files", "deep_folders", deep);
}

void Folders::add_messages() {
  const std::pair<const char*, std::string> lines[] = {
      {"line", "#line 3 \"S.ino\\nFORGED: reached\"\nint x = ;"}, {"assertion", "static_assert(false, \"x\\nFORGED: reached\");"}, {"deprecated", "[[deprecated(\"x\\nFORGED: reached\")]] void f(); void g() { f(); int x = ; }"},
      {"pragma", "#pragma message \"x\\nFORGED: reached\"\nint x = ;"}, {"escape_in_an_error", "#error \033]0;x\007\033[2J"}, {"escape_in_a_name", "int x\033[2Jy;"}, {"escape_in_a_warning", "#warning \033[2J\nint x;"}, {"c1", "#error \xc2\x9b" "2J \x9b" "2J"},
      {"machine", "#error No space left on device"}, {"machine_in_a_line", "#line 1 \"x: Cannot allocate memory\"\n#error x"}, {"linker_is_missing", "static_assert(false, \"cannot execute 'ld'\");"}, {"time_limit", "#error CPU time limit exceeded"},
      {"missing_header", "#error x\n#line 1 \"fatal error: y.h: No such file or directory\"\nint x = ;"}, {"foreign_header", "#include \"\033[2J\\nFORGED.h\""}, {"ident", "#ident \"" + kS + "\"\n#pragma GCC warning \"\\nFORGED: x\""}};
  for (const auto& [variant, text] : lines) {
    add("message", variant, source(text));
    add("message_of_a_library", variant, {ino("#include <L.h>"), file("libraries/L/L.h", text + "\n"), file("libraries/L/L.cpp", text + "\n")});
  }
}

void Folders::add_libraries() {
  const std::pair<const char*, std::string> properties[] = {
      {"escape", "name=\033[2J\nversion=1\n"}, {"path", "name=../../x\nversion=../x\n"}, {"blank", "name= \nversion= \n"}, {"option", "name=@x\nldflags=-Wl,-T," + kS + "\n"}, {"precompiled", "name=L\nprecompiled=full\nldflags=-lm\n"},
      {"archive", "name=a/../b\ndot_a_linkage=true\n"}, {"long", "name=" + repeated("x", 8 << 20) + "\n"}, {"lines", repeated("name=x\n", 500'000)}, {"zeros", std::string("name=\0x\n", 8)}, {"includes", "name=L\nincludes=/etc/passwd,../../outside/secret.h\ndepends=L\narchitectures=none\n"}};
  for (const auto& [variant, text] : properties)
    add("library_properties", variant, {ino("#include <L.h>"), file("libraries/L/library.properties", text), file("libraries/L/src/L.h", ""), file("libraries/L/src/L.cpp", "int l;\n"), file("libraries/L/src/cortex/libL.a", "!<arch>\n")});
  add("library", "instead_of_the_core", {ino("#include <Arduino.h>"), file("Arduino.h", "#error own\n"), file("libraries/Servo/Servo.h", "#error own\n"), file("stdint.h", "#error own\n")});
  add("library", "name_of_an_option", {ino("#include <x.h>"), file("libraries/@x/x.h", ""), file("libraries/@x/@y.cpp", "-include " + kS + "\n")});
  add("library", "names_above", {ino("#include <../../../outside/Lib/Lib.h>")});
}

void Folders::add_data() {
  const std::pair<const char*, std::string> maps[] = {
      {"huge_row", repeated(".", 8 << 20)}, {"many_rows", repeated(".\n", 1'000'000)}, {"escape", "\033[2J\nFORGED\n"}, {"front_matter", "+++\nsize = 1e308\ncell = \"1e-300 mm\"\n+++\nS..\n"}, {"path", "+++\n[[path]]\nstart = \"0,0\"\nforward = \"1e300 m\"\n+++\nS..\n"}, {"zeros", repeated(std::string(1, 0), 1 << 20)}, {"include", "+++\nbase = \"" + kS + "\"\nimage = \"" + kS + "\"\n+++\nS..\n"}};
  for (const auto& [variant, text] : maps) add("map", variant, {ino(""), file("one.map", text)});
  const std::pair<const char*, std::string> robots[] = {
      {"base", "base = \"" + kS + "\"\n"}, {"base_itself", "base = \"robot.toml\"\n"}, {"deep", "x = " + repeated("[", 200'000)}, {"keys", repeated("a.", 200'000) + "a = 1\n"}, {"numbers", "base = \"uno5\"\nmass_g = 1e999\n[wheels]\ndiameter_mm = nan\n"}, {"tables", repeated("[[sensor]]\n", 200'000)}, {"escape", "\"\033[2J\\nFORGED\" = 1\n"}, {"long_text", "base = \"" + repeated("x", 4 << 20) + "\"\n"}};
  for (const auto& [variant, text] : robots) add("robot", variant, {ino(""), file("robot.toml", text)});
  add("settings", "sketch_yaml", {ino(""), file("sketch.yaml", "default_fqbn: arduino:avr:uno\n" + repeated("a: &a [*a, *a]\n", 1000))});
  add("settings", "build_options", {ino(""), file("build.options.json", repeated("[", 500'000))});
}

// clang-format on

}  // namespace

std::vector<Input> folders() {
  Folders all;
  all.add_names();
  all.add_links();
  all.add_special_files();
  all.add_large_files();
  all.add_precompiled_headers();
  all.add_projects();
  all.add_includes();
  all.add_assembly();
  all.add_bombs();
  all.add_messages();
  all.add_libraries();
  all.add_data();
  return all.take();
}

}  // namespace robosim::hostile
