#include "sim/run/append_only_text.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace robosim::run::append_only_text_test {

TEST(AppendOnlyText, ComesBackAsItWasAndCopiesShareTheirBeginnings) {
  struct Moment {
    AppendOnlyText::Copy copy;
    std::string text;
  };
  std::mt19937 random(5);
  AppendOnlyText text;
  std::vector<Moment> moments{{text.save(), ""}};
  for (int i = 0; i < 200; ++i) {
    for (auto more = random() % 3000; more > 0; --more) text.add(static_cast<char>(random()));
    moments.push_back({text.save(), text.text()});
    if (i % 20 != 19) continue;
    // Restores the text of a random earlier moment. The text then continues differently.
    const Moment& before = moments[random() % moments.size()];
    text.restore(before.copy);
    ASSERT_EQ(text.text(), before.text) << i;
  }
  for (int i = 0; i < 100; ++i) {
    const Moment& moment = moments[random() % moments.size()];
    text.restore(moment.copy);
    ASSERT_EQ(text.text(), moment.text);
  }
  const AppendOnlyText::Copy first = text.save();
  text.add('x');
  const AppendOnlyText::Copy second = text.save();
  ASSERT_FALSE(first.pieces.empty());
  EXPECT_EQ(first.pieces, second.pieces);
  EXPECT_LT(second.rest.size(), 4096u);
}

}  // namespace robosim::run::append_only_text_test
