// Compiled into each test that robosim_add_test makes: what only CMake knows. The libraries ask for it where
// it is there.
extern "C" const char* robosim_installation() { return ROBOSIM_TEST_INSTALLATION; }
extern "C" const char* robosim_test_targets() { return ROBOSIM_TEST_TARGETS; }
