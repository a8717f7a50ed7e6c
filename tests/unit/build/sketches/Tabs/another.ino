int second() { return SECOND; }
void helper() { pinMode(LED_PIN, OUTPUT); }
