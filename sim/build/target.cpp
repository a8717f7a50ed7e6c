#include "sim/build/target.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/build/sketch.h"

namespace robosim::build {
namespace {

constexpr const char* kExports = "{ global: robosim_image; local: *; };\n";
// A linker script that the linker inserts before its default script. Moves constructors from .init_array to a
// section of Robosim, sorted by priority. Destructors are stored separately and never run: firmware on a
// microcontroller never ends.
constexpr const char* kSections = R"(SECTIONS
{
  robosim_init_array : ALIGN(8)
  {
    PROVIDE_HIDDEN(__start_robosim_init_array = .);
    KEEP(*(SORT_BY_INIT_PRIORITY(.init_array.*) SORT_BY_INIT_PRIORITY(.ctors.*)))
    KEEP(*(.init_array .ctors))
    PROVIDE_HIDDEN(__stop_robosim_init_array = .);
  }
  robosim_fini_array : { *(.fini_array.* .dtors.* .fini_array .dtors) }
}
INSERT BEFORE .data;
)";

/// Returns options that redirect calls of these functions to `__wrap_NAME` (hal/host/addresses.cpp).
std::vector<std::string> wrapped(std::vector<std::string> functions) {
  for (std::string& function : functions) function.insert(0, "-Wl,--wrap=");
  return functions;
}

// Builds a shared object for a runner. The options are fixed: the same code and compiler must give the same
// trace.
const Target kHost = {
    .name = "host",
    .image_ending = ".so",
    .cxx = {"g++", "g++"},
    .cc = {"gcc", "gcc"},
    .archiver = {},
    .native = true,
    .chip = false,
    .hal = "host",
    .code = {"-gdwarf-4", "-fPIC", "-fvisibility=hidden", "-fwrapv", "-fno-strict-aliasing", "-fsigned-char",
             "-ffp-contract=off",
             // As for avr-gcc, address 0 is valid. A write through a null pointer therefore stays in the
             // code, and is detected.
             "-fno-delete-null-pointer-checks",
             // Like Arduino's AVR core:
             "-ffunction-sections", "-fdata-sections",
             // A private copy of an image must share no symbol with other copies, and use nothing of the C++
             // library. It must also not contain paths of this machine, or defaults that differ between
             // distributions.
             "-fno-gnu-unique", "-fno-stack-protector", "-gno-record-gcc-switches",
             "-fno-canonical-system-headers", "-fdiagnostics-color=never", "-pipe", "-nostdinc"},
    .cxx_code = {"-std=gnu++14", "-fpermissive", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
                 "-nostdinc++", "-Wno-error=narrowing", "-Wno-builtin-declaration-mismatch"},
    .c_code = {"-std=gnu11", "-Wno-builtin-declaration-mismatch"},
    // A function that lacks its `return` statement still returns, as with avr-gcc. Without `unreachable`, gcc
    // would assume that the function's end is never reached, and continue with the code after the function. A
    // sketch can request -Os or -O2. gcc would then also insert a trap after a division by zero, which the
    // last option prevents.
    .own = {"-fsanitize-coverage=trace-pc", "-fsanitize=integer-divide-by-zero,unreachable",
            "-fno-isolate-erroneous-paths-dereference"},
    // A sketch's time is counted in blocks of its code, so its optimisation level must never change. The
    // costs of the core's functions are in a table.
    .own_level = "-O1",
    // Each access to memory that threads could share becomes a call into hal/host/register_memory.cpp.
    .memory = {"-DROBOSIM_REGISTER_MEMORY", "-fsanitize=thread", "--param=tsan-distinguish-volatile=1",
               "--param=tsan-instrument-func-entry-exit=0"},
    .as_avr = {"-D__AVR__", "-DARDUINO_ARCH_AVR", "-U__INT_WIDTH__", "-D__INT_WIDTH__=16"},
    .sanitizer =
        {// gcc defines << for negative numbers and for bits that are shifted out, so only the shift's
         // distance is checked. Uninitialised variables become visible: gcc fills them with bytes FE. Since
         // gcc 13, tree-ccp would replace a filled variable by the value that another path assigns. Neither a
         // warning nor a run would then reveal the missing value.
         .undefined = {"-fno-wrapv", "-ftrivial-auto-var-init=pattern", "-fno-tree-ccp",
                       "-fsanitize=alignment,bool,bounds,enum,float-cast-overflow,integer-divide-by-zero,"
                       "nonnull-attribute,null,pointer-overflow,return,shift-exponent,"
                       "signed-integer-overflow,unreachable,vla-bound"},
         // Each check becomes a call, which hal/host handles.
         .addresses = {"-fsanitize=address", "--param=asan-instrumentation-with-call-threshold=0",
                       "--param=asan-use-after-return=0"},
         .definitions = {"-DROBOSIM_SANITIZE"},
         .link = wrapped({"memcpy", "memmove", "memset", "memcmp", "strlen", "strcpy", "strncpy", "strcat",
                          "strncat", "strcmp", "strncmp", "strchr", "strstr"}),
         // This warning requires filled variables: otherwise the optimiser replaces a missing value by a
         // convenient value, without a warning.
         .warnings = {"-Wmaybe-uninitialized"}},
    // Without optimisation, each line keeps its code, and counters are in memory whenever control leaves the
    // firmware. The name of the counter data must not depend on folders. gcov checks that notes and data
    // belong to the same build.
    .coverage = {.own = {"-O0", "-fprofile-arcs", "-ftest-coverage", "-fprofile-info-section=robosim_gcov",
                         "-frandom-seed=robosim", "-dumpdir", "/robosim/"},
                 .definitions = {"-DROBOSIM_COVERAGE"},
                 .link = {"-lgcov"}},
    // The core's debug information has functions and lines, for a crash inside the core. The sketch's debug
    // information has everything that a debugger shows.
    .core = {"-g1", "-gno-column-info", "-gno-statement-frontiers"},
    .core_level = "-O2",
    .definitions = {"-DARDUINO_ARCH_HOST", "-DROBOSIM"},
    .prefix_map = "-ffile-prefix-map",
    // The loader must not run anything, and start files would add their own constructors. The linker's plugin
    // is disabled: no step needs the plugin, and it would compile bytecode that an asm() has put into an
    // object.
    .link = {"-shared", "-nostartfiles", "-static-libgcc", "-fuse-ld=bfd", "-fno-lto",
             "-fno-use-linker-plugin", "-Wl,-Bsymbolic", "-Wl,--no-undefined", "-Wl,--gc-sections",
             "-Wl,--build-id=none", "-Wl,-z,now",
             // An image is hashed and read before each run. Without this option, an image has about 800 KB.
             "-Wl,--compress-debug-sections=zlib",
             // Handlers that a sketch does not define must be null, even if the process defines their names.
             "-Wl,-z,nodynamic-undefined-weak", "-Wl,-z,noexecstack",
             // Redirects divisions on arm (hal/host/division.cpp).
             "-Wl,--wrap=__aeabi_idiv,--wrap=__aeabi_idivmod,--wrap=__aeabi_uidiv",
             "-Wl,--wrap=__aeabi_uidivmod,--wrap=__aeabi_ldivmod,--wrap=__aeabi_uldivmod"},
    .link_files = {{"exports.map", kExports}, {"sections.ld", kSections}},
    .products = {},
};

// The options equal those in platform.txt of Arduino's core 1.8.7, except for debug information. Debug
// information is DWARF (avr-gcc's default is stabs) without names of this machine. The code is the same as
// Arduino's, byte for byte. Without DECIMAL_DIG, the core's WString.cpp does not compile against avr-libc
// 2.0.
const Target kAvr = {
    .name = "avr",
    .image_ending = ".elf",
    .cxx = {"avr-g++", "gcc-avr"},
    .cc = {"avr-gcc", "gcc-avr"},
    .archiver = {"avr-gcc-ar", "gcc-avr"},
    .native = false,
    .chip = true,
    .hal = nullptr,
    .code = {"-gdwarf-4", "-gno-record-gcc-switches", "-ffunction-sections", "-fdata-sections", "-flto",
             "-fno-fat-lto-objects", "-fdiagnostics-color=never"},
    .cxx_code = {"-std=gnu++11", "-fpermissive", "-fno-exceptions", "-fno-threadsafe-statics",
                 "-Wno-error=narrowing"},
    .c_code = {"-std=gnu11"},
    .own = {},
    .own_level = "-Os",
    .memory = {},
    .as_avr = {},
    // Link-time optimisation of avr-gcc 5.4 fails for code with checks. Such code is also far larger than the
    // chip's flash. An image with the checks' handlers (hal/avr/undefined.c) therefore runs on a larger
    // emulated chip. That chip has 64 KB of flash. Its RAM ends at __stack, where the stack begins. RAMEND
    // has the same value (hal/avr/with_checks).
    .sanitizer = {.undefined = {"-fno-lto",
                                "-fsanitize=bounds,float-cast-overflow,integer-divide-by-zero,"
                                "shift,signed-integer-overflow"},
                  // The core is compiled without LTO, too. Otherwise its weak functions, such as
                  // initVariant(), override a library's functions.
                  .addresses = {"-fno-lto"},
                  .definitions = {},
                  .link = {"-Wl,-u,__ubsan_handle_add_overflow", "-Wl,--defsym=__stack=0xF8FF",
                           "-Wl,--defsym=__DATA_REGION_LENGTH__=0xF000",
                           "-Wl,--defsym=__TEXT_REGION_LENGTH__=0x10000"}},
    .core = {"-DDECIMAL_DIG=__DECIMAL_DIG__"},
    .core_level = "-Os",
    .definitions = {"-DARDUINO_ARCH_AVR"},
    .prefix_map = "-fdebug-prefix-map",
    // Makes avr-ld print demangled names. avr-gcc 14 does not pass on the spelling --demangle.
    .link = {"-Os", "-gdwarf-4", "-gno-record-gcc-switches", "-flto", "-fuse-linker-plugin",
             "-Wl,--gc-sections", "-Wl,-demangle"},
    .link_files = {},
    .products = {{".hex", {"avr-objcopy", "binutils-avr"}, {"-O", "ihex", "-R", ".eeprom"}}},
};

// Uses Robosim's own core, and the parts of newlib (its small variant) that sketches call. The headers are
// those of the host, so that a sketch sees the same names. As on every ARM, `char` is unsigned.
const Target kStm32 = {
    .name = "stm32",
    .image_ending = ".elf",
    .cxx = {"arm-none-eabi-g++", "gcc-arm-none-eabi"},
    .cc = {"arm-none-eabi-gcc", "gcc-arm-none-eabi"},
    .archiver = {"arm-none-eabi-ar", "binutils-arm-none-eabi"},
    .native = false,
    .chip = true,
    .hal = "stm32",
    .code = {"-mcpu=cortex-m3", "-mthumb", "-gdwarf-4", "-gno-record-gcc-switches", "-ffunction-sections",
             "-fdata-sections", "-fno-canonical-system-headers", "-fdiagnostics-color=never", "-nostdinc",
             // Without this option, a write through a null pointer is removed, with all code after it.
             "-fno-delete-null-pointer-checks"},
    .cxx_code = {"-std=gnu++14", "-fpermissive", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
                 "-fno-use-cxa-atexit", "-nostdinc++", "-Wno-error=narrowing",
                 "-Wno-builtin-declaration-mismatch"},
    .c_code = {"-std=gnu11", "-Wno-builtin-declaration-mismatch"},
    .own = {},
    .own_level = "-Os",
    .memory = {},
    .as_avr = {},
    .sanitizer = {},
    .coverage = {},
    .core = {},
    .core_level = "-Os",
    .definitions = {"-DARDUINO_ARCH_STM32", "-DSTM32F103xB"},
    .prefix_map = "-ffile-prefix-map",
    .link = {"-mcpu=cortex-m3", "-mthumb", "-nostartfiles", "--specs=nano.specs", "-fno-lto",
             "-fno-use-linker-plugin", "-Wl,--gc-sections", "-Wl,--build-id=none"},
    .link_files = {},
    .products = {{".bin", {"arm-none-eabi-objcopy", "binutils-arm-none-eabi"}, {"-O", "binary"}}},
};

const Target* const kTargets[] = {&kHost, &kAvr, &kStm32};

}  // namespace

const Target& find_target(const std::string& name) {
  for (const Target* target : kTargets)
    if (name == target->name) return *target;
  throw InputError(fmt::format("unknown target {}: expected {}", name, one_of(targets())));
}

std::vector<std::string> targets() {
  std::vector<std::string> names;
  for (const Target* target : kTargets) names.emplace_back(target->name);
  return names;
}

std::vector<std::string> boards_of(const std::string& target) {
  std::vector<std::string> names;
  if (!find_target(target).chip) return names;
  for (int i = 0; const BoardSpec* board = board_at(i); ++i)
    if (board->chip->target == target) names.emplace_back(board->name);
  return names;
}

}  // namespace robosim::build
