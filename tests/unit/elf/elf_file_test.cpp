#include "sim/base/elf/elf_file.h"

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>

#include "sim/base/elf/avr_device.h"
#include "sim/base/elf/elf_target.h"
#include "sim/base/error.h"
#include "sim/base/file.h"

namespace robosim {
namespace elf_file_test {

using ::testing::HasSubstr;

constexpr char kNames[] = "\0loop\0speed\0limit\0main.c\0outside\0.symtab\0.strtab";
constexpr std::uint32_t kLoop = 1, kSpeed = 6, kLimit = 12, kMainC = 18, kOutside = 25;
constexpr char kCode[] = "CODE";

/// A program for an AVR: a header, two segments, four bytes of code, and sections for code, zeroed data,
/// symbols and names.
struct Program {
  Elf32_Ehdr header{};
  Elf32_Phdr segments[2]{};
  char code[4]{};
  Elf32_Sym symbols[6]{};
  char names[sizeof kNames]{};
  Elf32_Shdr sections[5]{};

  Program() {
    std::memcpy(header.e_ident, ELFMAG, SELFMAG);
    header.e_ident[EI_CLASS] = ELFCLASS32;
    header.e_ident[EI_DATA] = ELFDATA2LSB;
    header.e_ident[EI_VERSION] = EV_CURRENT;
    header.e_type = ET_EXEC;
    header.e_machine = EM_AVR;
    header.e_version = EV_CURRENT;
    header.e_ehsize = sizeof header;
    header.e_phoff = offsetof(Program, segments);
    header.e_phentsize = sizeof(Elf32_Phdr);
    header.e_phnum = 2;
    header.e_shoff = offsetof(Program, sections);
    header.e_shentsize = sizeof(Elf32_Shdr);
    header.e_shnum = 5;
    std::memcpy(code, kCode, sizeof code);
    std::memcpy(names, kNames, sizeof names);
    segments[0] = {PT_LOAD, offsetof(Program, code), 0x100, 0x200, sizeof code, sizeof code, PF_R | PF_X, 1};
    segments[1] = {PT_LOAD, 0, 0x800100, 0x800100, 0, 16, PF_R | PF_W, 1};
    symbols[1] = {kMainC, 0, 0, ELF32_ST_INFO(STB_LOCAL, STT_FILE), 0, SHN_ABS};
    symbols[2] = {kLoop, 0x200, 4, ELF32_ST_INFO(STB_GLOBAL, STT_FUNC), 0, 1};
    symbols[3] = {kSpeed, 0x800100, 2, ELF32_ST_INFO(STB_GLOBAL, STT_OBJECT), 0, 2};
    symbols[4] = {kLimit, 24, 0, ELF32_ST_INFO(STB_GLOBAL, STT_NOTYPE), 0, SHN_ABS};
    symbols[5] = {kOutside, 0, 0, ELF32_ST_INFO(STB_GLOBAL, STT_NOTYPE), 0, SHN_UNDEF};
    sections[1] = {0, SHT_PROGBITS, SHF_ALLOC | SHF_EXECINSTR, 0x200, offsetof(Program, code), 4, 0, 0, 1, 0};
    sections[2] = {0, SHT_NOBITS, SHF_ALLOC | SHF_WRITE, 0x800100, 0, 16, 0, 0, 1, 0};
    sections[3] = {0, SHT_SYMTAB,       0, 0, offsetof(Program, symbols), sizeof symbols, 4, 2,
                   4, sizeof(Elf32_Sym)};
    sections[4] = {0, SHT_STRTAB, 0, 0, offsetof(Program, names), sizeof names, 0, 0, 1, 0};
  }
  std::string bytes() const { return {reinterpret_cast<const char*>(this), sizeof *this}; }
};

/// Reads all sections, segments and symbols. Returns the sum of counts and sizes, or the error message.
std::string read_all(const std::string& bytes) {
  try {
    const ElfFile file(bytes, "x.elf");
    std::size_t count = file.sections().size() + avr_device(file).size();
    for (const ElfSegment& segment : file.segments()) count += std::string(segment.bytes).size();
    for (const ElfSymbol& symbol : file.symbols()) count += std::string(symbol.name).size();
    return std::to_string(count);
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ElfFile, TellsForWhatItWasMade) {
  const ElfFile file(Program().bytes(), "x.elf");
  EXPECT_TRUE(file.is_for_avr());
  EXPECT_TRUE(file.is_program());
}

TEST(ElfFile, ReadsWhatIsLoaded) {
  const ElfFile file(Program().bytes(), "x.elf");
  const auto segments = file.segments();
  ASSERT_EQ(segments.size(), 1u) << "the other segment has no bytes in the file";
  EXPECT_EQ(segments[0].address, 0x200u) << "the physical address, not the virtual one";
  EXPECT_EQ(segments[0].bytes, kCode);
  EXPECT_TRUE(segments[0].code);
}

TEST(ElfFile, ReadsSections) {
  const ElfFile file(Program().bytes(), "x.elf");
  const auto sections = file.sections();
  ASSERT_EQ(sections.size(), 5u);
  EXPECT_TRUE(sections[1].loaded && !sections[1].writable && sections[1].has_content);
  EXPECT_TRUE(sections[2].loaded && sections[2].writable && !sections[2].has_content);
  EXPECT_EQ(sections[2].address, 0x800100u);
  EXPECT_EQ(sections[2].size, 16u);
  EXPECT_FALSE(sections[3].loaded);
}

TEST(ElfFile, ReadsSymbolsThatAreDefined) {
  const ElfFile file(Program().bytes(), "x.elf");
  const auto symbols = file.symbols();
  ASSERT_EQ(symbols.size(), 4u);
  EXPECT_EQ(symbols[0].kind, ElfSymbol::Kind::file_or_section);
  EXPECT_EQ(symbols[1].name, "loop");
  EXPECT_EQ(symbols[1].kind, ElfSymbol::Kind::function);
  EXPECT_EQ(symbols[1].value, 0x200u);
  EXPECT_EQ(symbols[1].size, 4u);
  EXPECT_EQ(symbols[2].kind, ElfSymbol::Kind::object);
  EXPECT_EQ(symbols[3].name, "limit");
  EXPECT_EQ(symbols[3].value, 24u);
  EXPECT_TRUE(symbols[3].absolute);
}

TEST(ElfFile, ReadsThisTestToo) {
  const ElfFile file(read_file("/proc/self/exe"), "test");
  const auto symbols = file.symbols();
  EXPECT_TRUE(std::any_of(symbols.begin(), symbols.end(), [](const ElfSymbol& symbol) {
    return symbol.name == "main" && symbol.kind == ElfSymbol::Kind::function;
  }));
}

TEST(ElfFile, WhatIsNoneIsRefusedWithItsName) {
  EXPECT_EQ(read_all("hello"), "x.elf: not an ELF file");
  EXPECT_EQ(read_all(""), "x.elf: not an ELF file");
  EXPECT_EQ(read_all(Program().bytes().substr(0, sizeof(Elf32_Ehdr) - 1)), "x.elf: not an ELF file");
}

std::string target_of(std::string bytes) {
  try {
    return target_of_elf(bytes, "x.elf");
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ElfFile, TellsWhichTargetRunsItByItsHeaderAlone) {
  const std::string
      good = Program().bytes(),
      none = "x.elf: expected a program for a chip that Robosim knows (an AVR or an ARM microcontroller)";
  EXPECT_EQ(target_of(good.substr(0, sizeof(Elf32_Ehdr))), "avr");
  for (const auto& [at, byte, target] : {std::tuple{18, char{EM_ARM}, std::string("stm32")},
                                         {18, char{EM_386}, none},
                                         {EI_CLASS, char{ELFCLASS64}, none},
                                         {EI_DATA, char{ELFDATA2MSB}, none},
                                         {EI_VERSION, char{2}, none}}) {
    std::string changed = good;
    changed[static_cast<std::size_t>(at)] = byte;
    EXPECT_EQ(target_of(changed), target) << at;
  }
  for (const char* other : {"", "hello"}) EXPECT_EQ(target_of(other), none);
}

TEST(ElfFile, AFileThatEndsTooEarlyIsRefused) {
  const std::string good = Program().bytes();
  ASSERT_EQ(read_all(good), std::to_string(5 + 4 + 6 + 4 + 5 + 5));
  for (std::size_t size = sizeof(Elf32_Ehdr); size < good.size(); ++size)
    EXPECT_EQ(read_all(good.substr(0, size)),
              "x.elf: the ELF file is damaged: a table or section is outside the file")
        << size;
}

TEST(ElfFile, TablesAndContentsOutsideTheFileAreRefused) {
  const auto refusal = [](const std::function<void(Program&)>& spoil) {
    Program program;
    spoil(program);
    return read_all(program.bytes());
  };
  const auto is_refused = HasSubstr("x.elf: the ELF file is damaged");
  EXPECT_THAT(refusal([](Program& p) { p.header.e_shoff = 1'000'000; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.header.e_shoff = 0xFFFFFFF0; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.header.e_shnum = 6; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.header.e_phoff = 0xFFFFFFF0; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.header.e_phnum = 0xFFFE; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.header.e_phentsize = 4; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.segments[0].p_offset = 0xFFFFFFFE; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.segments[0].p_filesz = 0x7FFFFFFF; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.sections[3].sh_offset = 0xFFFFFFF0; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.sections[3].sh_size = 0x7FFFFFFF; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.sections[3].sh_link = 77; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.symbols[2].st_name = 10'000; }), is_refused);
  EXPECT_THAT(refusal([](Program& p) { p.sections[4].sh_size = 3; }), is_refused);
}

TEST(ElfFile, AFlippedBitIsReadOrRefusedAndNeverMore) {
  const std::string good = Program().bytes();
  for (std::size_t at = 0; at < good.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ 1 << bit);
      EXPECT_NE(read_all(bad), "");
    }
  }
}

}  // namespace elf_file_test
}  // namespace robosim
