#pragma once
extern int blinks;
