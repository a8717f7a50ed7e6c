#pragma once
#include <util/delay.h>
