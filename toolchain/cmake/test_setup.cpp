// Provides values that only CMake has. robosim_add_test compiles this file into each test. The libraries use
// the values if they are present.
extern "C" const char* robosim_installation() { return ROBOSIM_TEST_INSTALLATION; }
extern "C" const char* robosim_test_targets() { return ROBOSIM_TEST_TARGETS; }
