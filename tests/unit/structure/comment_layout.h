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
/// A tool that wraps a row as prose moves the row's last words to the next line: alone, or in front of the
/// next row's label. People make the same mistake when a row has grown. A line is reported if it starts
/// at the labels' column, and the row above has no room for its first word. One of these conditions must also
/// hold:
///
///   - the row above has an open bracket, or ends with an operator or a comma;
///   - the line is short, and it is the table's last one or precedes a line at the last cell's column;
///   - if the line's first words are removed, its second cell is at the same column as that of the row above.
///
/// A line is also reported if it starts left of the last cell of the row above, and reaches under this cell.
/// Rows without a second cell, labels that are wider than their column, nested lists and pictures are not
/// reported.
std::vector<std::string> broken_rows(const Files& files, std::size_t limit);

}  // namespace robosim::structure
