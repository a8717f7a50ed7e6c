#include "sim/base/robot_name.h"

namespace robosim {

RobotName parse_robot_name(const std::string& text) {
  const std::size_t at = text.rfind('@');
  if (at == text.npos || at + 1 == text.size() || text.find_first_of("/.", at) != text.npos)
    return {text, ""};
  return {text.substr(0, at), text.substr(at + 1)};
}

std::string robot_with_board(const std::string& text, const std::string& board) {
  return parse_robot_name(text).robot + "@" + board;
}

}  // namespace robosim
