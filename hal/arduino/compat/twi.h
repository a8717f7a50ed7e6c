#pragma once
#include <util/twi.h>
