// Formats a guessed robot as the text of a robot file, with its evidence and the questions to the user.
#pragma once

#include <string>
#include <vector>

#include "sim/campaign/wiring/guess.h"

namespace robosim::wiring {

/// Returns the robot file's text. `remarks` are sentences that appear at the top of the text.
std::string text_of(const RobotDraft& draft, const std::vector<std::string>& remarks = {});

/// Returns "black reads LOW, motors swapped", or "as guessed first".
std::string text_of(const Ways& ways);

/// Removes the part at this line of the draft's text, which the reader of robot files refuses with `message`.
/// The part becomes a question. If the line is not in a part, removes the standby pin or, without one, all
/// parts. Returns false if there was nothing to remove.
bool remove_refused(RobotDraft& draft, int line, const std::string& message);

/// Returns lines of a script that presses each button of the draft twice.
std::string presses(const RobotDraft& draft);

}  // namespace robosim::wiring
