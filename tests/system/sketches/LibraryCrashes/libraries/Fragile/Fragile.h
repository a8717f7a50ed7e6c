#pragma once
void fragile(int* value);
