// Small floors, so that a chip scans them in seconds.
#pragma once

/// Three stations and a junction: 1 at the left, where the robot starts, 2 below, 3 at the right.
inline constexpr const char* kTee = R"(+++
name = "tee"
+++
_____________
_____________
_____________
___S......___
______.______
______.______
______.______
_____________
_____________
_____________
)";
