#include "sim/exec/elf/symbols.h"

#include <gtest/gtest.h>

namespace robosim::exec::symbols_test {

TEST(Symbols, ALabelOfTheAssemblerIsNotAFunction) {
  Symbols symbols;
  symbols.add({"main", 0x120, 0xba, true});
  symbols.add({".Loc.12", 0x152, 0, true});
  symbols.add({"L0\1", 0x1a0, 0, true});
  symbols.sort();
  const Symbol* const function = symbols.function_at(0x1aa);
  ASSERT_TRUE(function);
  EXPECT_EQ(function->name, "main");
  EXPECT_FALSE(symbols.find(".Loc.12"));
  EXPECT_FALSE(symbols.find("L0\1"));
}

}  // namespace robosim::exec::symbols_test
