// Provides values that only CMake knows. robosim_add_test() compiles this file into each test. Robosim's
// libraries use these functions if a program contains them.
extern "C" const char* robosim_installation() { return ROBOSIM_TEST_INSTALLATION; }
extern "C" const char* robosim_test_targets() { return ROBOSIM_TEST_TARGETS; }
