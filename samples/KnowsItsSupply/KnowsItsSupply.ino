/*
  Measures the supply without extra parts: the ADC compares the chip's 1.1 V reference with the supply
  ("secret voltmeter"). The measured supply scales the reading of the battery's divider, because the supply
  may sink with the battery. The robot stops before the battery is too low for the motor driver.
*/
const byte EN_L = 5, IN1_L = 7, EN_R = 6, IN1_R = 9, BATTERY = A5;
const long BANDGAP_MV = 1100;

long supply_mv() {
  ADMUX = _BV(REFS0) | _BV(MUX3) | _BV(MUX2) | _BV(MUX1);   // 1.1 V relative to the supply
  delay(2);
  ADCSRA |= _BV(ADSC);
  while (ADCSRA & _BV(ADSC)) ;
  return BANDGAP_MV * 1024 / ADC;
}

void setup() {
  Serial.begin(115200);
  pinMode(EN_L, OUTPUT);
  pinMode(EN_R, OUTPUT);
  pinMode(IN1_L, OUTPUT);
  pinMode(IN1_R, OUTPUT);
  digitalWrite(IN1_L, HIGH);
  digitalWrite(IN1_R, HIGH);
}

void loop() {
  const long supply = supply_mv();
  const long battery = 2L * analogRead(BATTERY) * supply / 1024;   // the divider halves the voltage
  Serial.print(F("supply "));
  Serial.print((supply + 50) / 100);
  Serial.print(F(" battery "));
  Serial.println((battery + 50) / 100);
  const bool enough = battery > 6000;
  analogWrite(EN_L, enough ? 60 : 0);
  analogWrite(EN_R, enough ? 60 : 0);
  if (!enough) Serial.println(F("empty"));
  delay(200);
}
