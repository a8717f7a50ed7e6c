// Checks the layout of comments: the length of lines, and the column at which rows of tables continue.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/unit/structure/include_table.h"

namespace robosim::structure {

/// Returns a message for each comment line that has more than `limit` columns. A character is one column.
std::vector<std::string> long_comments(const Files& files, std::size_t limit);

/// Returns a message for each line of a comment that continues a row at a wrong column. A row is part of a
/// table or formula. It is indented by two columns or more; two spaces or more separate its cells:
///
///   label   a row that fills its line up to the limit, continued
///           at the column of its last cell
///
/// Tools that wrap a row as if it were prose put the rest at the label's column, or before the next label.
/// People do so, too, when a row has grown. A line is reported if it follows a row without space for the
/// line's first word, starts at the row's label, and
///
///   - the row has an open bracket, or ends with an operator or a comma;
///   - or the line is a short text, at the table's end or before a line at the column of the last cell;
///   - or the line's last cell would be at the row's column without the line's first words.
///
/// A line is also reported if it starts before the last cell of the previous row and continues below that
/// cell. Rows without a second cell, labels wider than their column, nested lists and pictures are not
/// reported.
std::vector<std::string> broken_rows(const Files& files, std::size_t limit);

}  // namespace robosim::structure
