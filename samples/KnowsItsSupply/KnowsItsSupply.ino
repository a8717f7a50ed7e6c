/*
  Learns its supply from the chip's own 1.1 V, without a part for it: measures that against the supply, as in many
  battery-powered projects ("secret voltmeter"). So it also knows what its battery's divider is worth when the supply
  sinks with the battery; and it stops while there is still enough for its motors' driver to obey.
*/
const byte EN_L = 5, IN1_L = 7, EN_R = 6, IN1_R = 9, BATTERY = A5;
const long BANDGAP_MV = 1100;

long supply_mv() {
  ADMUX = _BV(REFS0) | _BV(MUX3) | _BV(MUX2) | _BV(MUX1);   // 1.1 V against the supply
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
  const long battery = 2L * analogRead(BATTERY) * supply / 1024;   // a divider by two
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
