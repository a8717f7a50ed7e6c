// Defines limits that a sketch's size report can print.
//
//   LINEKIT_LIMIT(kTreeNodes, nodes_of_a_tree, 200);
//
// defines the constant nav::kTreeNodes and, in the object file, the symbol linekit_limit_nodes_of_a_tree with
// the value 200. This is a local absolute symbol: a name and a number in the symbol table, without a byte of
// flash or RAM. Read it from any .elf or .so that was not stripped, on every target:
//
//   $ avr-nm AiNavigator.elf | grep linekit_limit_
//   000000c8 a linekit_limit_nodes_of_a_tree
//
// Write the number in decimal: the preprocessor copies it into the assembler's text. If several files include
// this header, the symbol occurs several times, always with the same value.
#ifndef LINEKIT_NAV_LIMITS_H
#define LINEKIT_NAV_LIMITS_H

#include <stdint.h>

// A sketch can set the number of nodes before its first #include:  #define LINEKIT_TREE_NODES 230
#ifndef LINEKIT_TREE_NODES
#define LINEKIT_TREE_NODES 200
#endif

#define LINEKIT_REPORT_LIMIT(name, value) __asm__(".set linekit_limit_" #name ", " #value)
/// Defines two more symbols for a limit: the bytes of RAM for one more item, and the highest allowed limit.
/// From these symbols, robosim run prints how many items fit in RAM together with the deepest stack.
#define LINEKIT_LIMIT_GROWS(name, bytes_each, most)           \
  __asm__(".set linekit_bytes_each_" #name ", " #bytes_each); \
  __asm__(".set linekit_most_" #name ", " #most)
#define LINEKIT_LIMIT(constant, name, value) \
  LINEKIT_REPORT_LIMIT(name, value);         \
  static const uint8_t constant = value

namespace nav {

LINEKIT_LIMIT(kTreeNodes, nodes_of_a_tree, LINEKIT_TREE_NODES);       // stations and junctions
LINEKIT_LIMIT(kCyclicJunctions, junctions_of_a_net_with_cycles, 64);  // junctions among the kTreeNodes nodes

}  // namespace nav

#endif
