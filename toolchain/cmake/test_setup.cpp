// Compiled into each test that robosim_add_test makes: values that only CMake has. The libraries use them if
// they are present.
extern "C" const char* robosim_installation() { return ROBOSIM_TEST_INSTALLATION; }
extern "C" const char* robosim_test_targets() { return ROBOSIM_TEST_TARGETS; }
