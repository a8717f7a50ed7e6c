// Finds the declarations of arithmetic variables in preprocessed C++, with their types and scopes.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <string_view>
#include <vector>

#include "sim/build/tokens.h"

namespace robosim::build {

struct ArithmeticType {
  int bits = 0;  ///< 0 = another type, or unknown
  bool is_signed = false;
  bool is_float = false;
};

struct Declaration {
  std::string_view name;
  ArithmeticType type;
  std::size_t at = 0;  ///< index of the name's word
  /// Index of the word that ends the scope of a parameter or local variable; 0 = a member, or a variable of a
  /// namespace.
  std::size_t end = 0;
};

/// The declarations in a list of words. Function names are also declarations, of unknown type.
class Declarations {
 public:
  /// A name with more declarations is not resolved. Otherwise a search could take quadratic time.
  static constexpr std::size_t kMostOfName = 200;
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  Declarations(const std::vector<Token>& words, int int_bits);

  const std::vector<Declaration>& all() const { return declarations_; }
  /// Returns the index of the bracket that belongs to the bracket at `at`, or kNone.
  std::size_t partner(std::size_t at) const { return partners_[at]; }
  /// Returns the index of the declaration that a name at `at` refers to, or kNone. Members with the same name
  /// count as one declaration, even if their classes differ. `is_member` excludes local variables. Returns
  /// kNone for a name with very many declarations.
  std::size_t resolve(std::size_t at, bool is_member) const;
  /// Reads a type at `at`. Returns the index after the type, or `at` if no arithmetic type begins there.
  std::size_t read_type(std::size_t at, ArithmeticType& type) const;
  /// Returns whether the name has declarations, and `accepts` returns true for the types of all of them.
  template <typename Accepts>
  bool all_of(std::string_view name, Accepts accepts) const {
    const auto [begin, end] = by_name_.equal_range(name);
    std::size_t count = 0;
    for (auto one = begin; one != end; ++one)
      if (++count > kMostOfName || !accepts(declarations_[one->second].type)) return false;
    return begin != end;
  }

 private:
  void find_partners();
  void read_declarations();
  std::size_t read_declarators(std::size_t at, const ArithmeticType& type, std::size_t open);
  void add(std::size_t at, const ArithmeticType& type, std::size_t open);
  bool is_class(std::size_t brace) const;
  bool names_type(std::size_t at) const;
  std::string_view text(std::size_t at) const { return at < words_.size() ? words_[at].text : ""; }

  const std::vector<Token>& words_;
  int int_bits_;
  std::vector<std::size_t> partners_;
  std::vector<Declaration> declarations_;
  std::multimap<std::string_view, std::size_t> by_name_;
};

}  // namespace robosim::build
