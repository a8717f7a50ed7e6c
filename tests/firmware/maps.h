// Small floors that a chip scans in seconds.
#pragma once

/// Three stations and a junction: station 1 at the left, where the robot starts, station 2 below, station 3
/// at the right.
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

/// Twelve stations.
inline constexpr const char* kComb = R"(+++
name = "comb"
+++
__________________________________________________
__________________________________________________
__________________________________________________
___S...........................................___
_______.___.___.___.___.___.___.___.___.___.______
_______.___.___.___.___.___.___.___.___.___.______
_______.___.___.___.___.___.___.___.___.___.______
__________________________________________________
__________________________________________________
__________________________________________________
)";

/// Two junctions between station 1 and station 2, connected by two routes: 4 cells straight on, or 16 cells
/// via the south.
inline constexpr const char* kRing = R"(+++
name = "ring"
+++
_________________
_________________
_________________
___S..........___
______.___.______
______.___.______
______.___.______
______.___.______
______.___.______
______.....______
_________________
_________________
_________________
)";

/// Two junctions, connected by two routes: 12 cells straight on, or 20 cells via the south. The longer route
/// has a third junction, from which a line leads to a station.
inline constexpr const char* kWideRing = R"(+++
name = "wide ring"
+++
________________________
________________________
________________________
___S.................___
______.___________._____
______._____._____._____
______._____._____._____
______............._____
________________________
________________________
________________________
)";

/// Station 1 and station 3 are 21 cells apart along the row of junctions. There are two detours: from the
/// second junction via the north (20 cells instead of 12), and from the third junction via the south (18
/// instead of 8).
inline constexpr const char* kTwoRings = R"(+++
name = "two rings"
+++
____________________________
____________________________
____________________________
_________.............______
_________.___________.______
_________._______.___.______
_________._______.___.______
___S.....................___
______.______._______.______
______.______._______.______
_____________._______.______
_____________._______.______
_____________.........______
____________________________
____________________________
____________________________
)";

/// Two routes from junction 1 to junction 2, as in kRing. A line leads from junction 1 to station 3. A robot
/// that comes from station 1 must turn left at junction 1 to reach station 3.
inline constexpr const char* kRingOfThree = R"(+++
name = "ring of three"
+++
____________________
____________________
____________________
______._____________
______._____________
______._____________
___S.............___
______.___._________
______.___._________
______.___._________
______.___._________
______.___._________
______....._________
____________________
____________________
____________________
)";
