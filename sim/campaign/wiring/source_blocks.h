// Splits the functions of a sketch into blocks of statements, with the conditions under which each block
// runs.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "sim/build/tokens.h"
#include "sim/campaign/wiring/name_words.h"

namespace robosim::wiring {

using build::kEndOfDefine;
using build::Token;
using build::tokens_of;
using Tokens = std::vector<Token>;

struct Condition {
  Tokens tokens;            ///< without the outer parentheses; for a case label, `value == label`
  bool is_negated = false;  ///< the block is in the else branch
  int line = 0;
};

struct Statement {
  Tokens tokens;  ///< without the semicolon
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
  std::size_t function_begin = 0, function_end = 0;  ///< indexes of the function's tokens
  bool runs = true;                                  ///< false if nothing calls the function
};

/// One line of a comment.
struct Comment : build::Comment {
  WordList words;
};

/// A file of the sketch.
struct SourceText {
  SourceText(std::string name, std::string content);

  std::string file;
  std::shared_ptr<const std::string> text;  ///< tokens and comments refer to it
  Tokens tokens;
  std::vector<Comment> comments;
  std::vector<Block> blocks;
};

/// Finds the blocks that run: those that setup(), loop(), an interrupt handler or the initial value of a
/// global variable can reach. All blocks run in a source without setup() and loop().
void mark_running(std::vector<SourceText>& sources);

/// Returns the blocks of all functions, also of methods. Skips initialisers of variables.
std::vector<Block> blocks_of(const Tokens& tokens);

/// Returns the words of all names in the tokens.
WordList words_of(const Tokens& tokens);

/// Returns how often each word is assigned, also by ++ or +=. Does not count definitions by #define.
std::map<std::string, int> assignments_in(const std::vector<SourceText>& sources);

}  // namespace robosim::wiring
