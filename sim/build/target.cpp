#include "sim/build/target.h"

#include <fmt/format.h>

#include "sim/base/error.h"
#include "sim/build/sketch.h"

namespace robosim::build {
namespace {

constexpr const char* kExports = "{ global: robosim_image; local: *; };\n";
// Before the default script, so that constructors are taken out of .init_array, in the order of their
// priority. Destructors are stored separately and never run: firmware on a microcontroller never ends.
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

/// The linker redirects calls of these to `__wrap_NAME` (hal/host/addresses.cpp).
std::vector<std::string> wrapped(std::vector<std::string> functions) {
  for (std::string& function : functions) function.insert(0, "-Wl,--wrap=");
  return functions;
}

// A shared object for a runner. Fixed: the same code on the same compiler must give the same trace.
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
             // Like avr-gcc, for which address 0 is valid: a write through a null pointer stays in the code,
             // and is detected.
             "-fno-delete-null-pointer-checks",
             // Like Arduino's AVR core:
             "-ffunction-sections", "-fdata-sections",
             // Requirements of a private copy of an image: no symbol shared between copies, nothing from the
             // C++ library. Also no names of this machine inside, and no defaults that differ between
             // distributions.
             "-fno-gnu-unique", "-fno-stack-protector", "-gno-record-gcc-switches",
             "-fno-canonical-system-headers", "-fdiagnostics-color=never", "-pipe", "-nostdinc"},
    .cxx_code = {"-std=gnu++14", "-fpermissive", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
                 "-nostdinc++", "-Wno-error=narrowing", "-Wno-builtin-declaration-mismatch"},
    .c_code = {"-std=gnu11", "-Wno-builtin-declaration-mismatch"},
    // A function without its `return` returns, as with avr-gcc. Without `unreachable` gcc treats its end as
    // unreachable, and runs the code after it. If a sketch requests -Os or more, gcc would end a path that
    // has divided by zero with a trap.
    .own = {"-fsanitize-coverage=trace-pc", "-fsanitize=integer-divide-by-zero,unreachable",
            "-fno-isolate-erroneous-paths-dereference"},
    // A sketch's time is counted in blocks of its code, so its level is fixed for ever. The core's costs are
    // in its table.
    .own_level = "-O1",
    // Each access to shared memory is a call, which hal/host/register_memory.cpp handles.
    .memory = {"-DROBOSIM_REGISTER_MEMORY", "-fsanitize=thread", "--param=tsan-distinguish-volatile=1",
               "--param=tsan-instrument-func-entry-exit=0"},
    .as_avr = {"-D__AVR__", "-DARDUINO_ARCH_AVR", "-U__INT_WIDTH__", "-D__INT_WIDTH__=16"},
    .sanitizer =
        {// gcc defines << for negative numbers and for bits that are shifted out: only the distance is
         // checked. Uninitialised variables show: gcc fills them with bytes FE. From gcc 13 on tree-ccp
         // replaces a filled variable by the value that another path assigns. Then neither a warning nor a
         // run shows it.
         .undefined = {"-fno-wrapv", "-ftrivial-auto-var-init=pattern", "-fno-tree-ccp",
                       "-fsanitize=alignment,bool,bounds,enum,float-cast-overflow,integer-divide-by-zero,"
                       "nonnull-attribute,null,pointer-overflow,return,shift-exponent,"
                       "signed-integer-overflow,unreachable,vla-bound"},
         // Each check is a call, which hal/host handles.
         .addresses = {"-fsanitize=address", "--param=asan-instrumentation-with-call-threshold=0",
                       "--param=asan-use-after-return=0"},
         .definitions = {"-DROBOSIM_SANITIZE"},
         .link = wrapped({"memcpy", "memmove", "memset", "memcmp", "strlen", "strcpy", "strncpy", "strcat",
                          "strncat", "strcmp", "strncmp", "strchr", "strstr"}),
         // If locals are not filled, the optimiser chooses a convenient value for a missing one, without a
         // warning.
         .warnings = {"-Wmaybe-uninitialized"}},
    // Not optimised: a line keeps its code, and a counter is in memory whenever the firmware is left. The
    // data's name must not depend on folders, and gcov checks that notes and data are of the same build.
    .coverage = {.own = {"-O0", "-fprofile-arcs", "-ftest-coverage", "-fprofile-info-section=robosim_gcov",
                         "-frandom-seed=robosim", "-dumpdir", "/robosim/"},
                 .definitions = {"-DROBOSIM_COVERAGE"},
                 .link = {"-lgcov"}},
    // Functions and lines, for a crash inside it; for the sketch everything that a debugger shows.
    .core = {"-g1", "-gno-column-info", "-gno-statement-frontiers"},
    .core_level = "-O2",
    .definitions = {"-DARDUINO_ARCH_HOST", "-DROBOSIM"},
    .prefix_map = "-ffile-prefix-map",
    // The loader must not run anything: start files add their own constructors.
    // Without the linker's plugin: nothing here is optimised at link time, and it would compile bytecode that
    // an asm() has put into an object.
    .link = {"-shared", "-nostartfiles", "-static-libgcc", "-fuse-ld=bfd", "-fno-lto",
             "-fno-use-linker-plugin", "-Wl,-Bsymbolic", "-Wl,--no-undefined", "-Wl,--gc-sections",
             "-Wl,--build-id=none", "-Wl,-z,now",
             // An image is hashed and read before each run: without this it has some 800 KB.
             "-Wl,--compress-debug-sections=zlib",
             // Handlers that a sketch does not define are null, even if the process has them.
             "-Wl,-z,nodynamic-undefined-weak", "-Wl,-z,noexecstack",
             // For arm: hal/host/division.cpp.
             "-Wl,--wrap=__aeabi_idiv,--wrap=__aeabi_idivmod,--wrap=__aeabi_uidiv",
             "-Wl,--wrap=__aeabi_uidivmod,--wrap=__aeabi_ldivmod,--wrap=__aeabi_uldivmod"},
    .link_files = {{"exports.map", kExports}, {"sections.ld", kSections}},
    .products = {},
};

// As in Arduino's platform.txt of the core 1.8.7, except for debug information. That is DWARF (avr-gcc's
// default is stabs) and has no names of this machine. The code is the same, byte for byte. Without
// DECIMAL_DIG the core's WString.cpp does not compile against avr-libc 2.0.
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
    // Link-time optimisation of avr-gcc 5.4 fails for code with checks. That is far larger than the chip. For
    // an image with handlers (hal/avr/undefined.c), the executor's chip has 64 KB of flash, and RAM up to the
    // start of its stack. That is also RAMEND (hal/avr/with_checks).
    .sanitizer = {.undefined = {"-fno-lto",
                                "-fsanitize=bounds,float-cast-overflow,integer-divide-by-zero,"
                                "shift,signed-integer-overflow"},
                  // Also for the core: otherwise its weak functions, such as initVariant(), override a
                  // library's.
                  .addresses = {"-fno-lto"},
                  .definitions = {},
                  .link = {"-Wl,-u,__ubsan_handle_add_overflow", "-Wl,--defsym=__stack=0xF8FF",
                           "-Wl,--defsym=__DATA_REGION_LENGTH__=0xF000",
                           "-Wl,--defsym=__TEXT_REGION_LENGTH__=0x10000"}},
    .core = {"-DDECIMAL_DIG=__DECIMAL_DIG__"},
    .core_level = "-Os",
    .definitions = {"-DARDUINO_ARCH_AVR"},
    .prefix_map = "-fdebug-prefix-map",
    // avr-gcc 14 does not pass --demangle to avr-ld, which then prints mangled names; it does pass this
    // spelling.
    .link = {"-Os", "-gdwarf-4", "-gno-record-gcc-switches", "-flto", "-fuse-linker-plugin",
             "-Wl,--gc-sections", "-Wl,-demangle"},
    .link_files = {},
    .products = {{".hex", {"avr-objcopy", "binutils-avr"}, {"-O", "ihex", "-R", ".eeprom"}}},
};

// Our own core, and the parts of newlib (its small variant) that sketches call. Headers are the host's, so
// that a sketch sees the same names. As on every ARM, `char` is unsigned.
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
             // Otherwise a write through a null pointer is removed, with all that follows it.
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
