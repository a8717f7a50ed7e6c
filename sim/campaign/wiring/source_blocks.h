// Splits the functions of a sketch into blocks of statements, with the conditions under which each block
// runs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/campaign/wiring/tokens.h"

namespace robosim::wiring {

struct Condition {
  std::vector<Token> tokens;  ///< without the outer parentheses; for a case label, `value == label`
  bool is_negated = false;    ///< the block is in the else branch
  int line = 0;
};

struct Statement {
  std::vector<Token> tokens;  ///< without the semicolon
  int line = 0;
};

/// The statements between two braces, without those of inner blocks.
struct Block {
  std::string function;
  std::vector<std::string> parameters;
  std::vector<Condition> conditions;  ///< the outermost first
  bool has_case = false;              ///< the last condition is a case label
  std::vector<Statement> statements;
  int first_line = 0, last_line = 0;
};

/// A file of the sketch.
struct SourceText {
  std::string file;
  std::vector<Token> tokens;
  std::vector<Comment> comments;
  std::vector<Block> blocks;
};

/// Returns the blocks of all functions, also of methods. Skips initialisers of variables.
std::vector<Block> blocks_of(const std::vector<Token>& tokens);

/// Returns how often each word is assigned, also by ++ or +=. Does not count definitions by #define.
std::map<std::string, int> assignments_in(const std::vector<SourceText>& sources);

}  // namespace robosim::wiring
