// Checks the layout of comments: the length of lines, and the column at which a table's row continues on the
// next line.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// Returns a message for each comment line with more than `limit` columns. A character counts as one column.
std::vector<std::string> long_comments(const Files& files, std::size_t limit);

/// Returns a message for each line of a comment that continues a row at a wrong column. A row is part of a
/// table or formula. It is indented by two columns or more; two spaces or more separate its cells:
///
///   label   a row that fills its line up to the limit, continued
///           at the column of its last cell
///
/// A tool that wraps a row like prose puts the row's rest at the label's column, or before the next label.
/// People make the same mistake when a row has grown. A line is reported if it starts at the label's column
/// and its first word would overflow the row. One of these conditions must also hold:
///
///   - the row has an open bracket, or ends with an operator or a comma;
///   - the line is a short text, at the table's end or before a line at the column of the last cell;
///   - without its first words, the line would have its second cell at the column of the row's second cell.
///
/// A line is also reported if it starts before the previous row's last cell and continues below that cell.
/// Rows without a second cell, labels that are wider than their column, nested lists and pictures are not
/// reported.
std::vector<std::string> broken_rows(const Files& files, std::size_t limit);

}  // namespace robosim::structure
