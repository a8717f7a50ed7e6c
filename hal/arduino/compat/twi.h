// The former name of <util/twi.h> in avr-libc.
#pragma once
#include <util/twi.h>
