#include "sim/base/markup.h"

#include <gtest/gtest.h>

namespace robosim::markup_test {

TEST(Markup, IsTextThatMarksUpNothing) {
  EXPECT_EQ(markup_text("a < b & \"c\" > d\n\te"), "a &lt; b &amp; &quot;c&quot; &gt; d&#10;\te");
  EXPECT_EQ(markup_text("Spur \xC3\xA4, \xE2\x9C\x93, \xF0\x9F\xA4\x96"),
            "Spur \xC3\xA4, \xE2\x9C\x93, \xF0\x9F\xA4\x96");
}

TEST(Markup, HoldsNothingThatXmlDoesNotAllow) {
  constexpr const char* kReplacement = "\xEF\xBF\xBD";
  for (const char* text : {"\x01", "\x1B", "\xFF", "\xC3", "\xED\xA0\x80", "\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    EXPECT_EQ(markup_text(text).substr(0, 3), kReplacement) << text;
  EXPECT_EQ(markup_text("a\xFF<"), std::string("a") + kReplacement + "&lt;");
}

}  // namespace robosim::markup_test
