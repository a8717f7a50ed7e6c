// My first robot! Two IR sensor modules and an L298N board.
// The ENA and ENB jumpers are set, so PWM on the IN pins controls the speed.

#define sensorIzq 7
#define sensorDer 8

int IN1 = 5;
int IN2 = 4;
int IN3 = 6;
int IN4 = 3;

int velocidad = 150;

void setup() {
  pinMode(sensorIzq, INPUT);
  pinMode(sensorDer, INPUT);
  pinMode(IN1, OUTPUT);
  pinMode(IN2, OUTPUT);
  pinMode(IN3, OUTPUT);
  pinMode(IN4, OUTPUT);
  Serial.begin(9600);
}

void loop() {
  int izq = digitalRead(sensorIzq);
  int der = digitalRead(sensorDer);

  // LOW = white (the LED of the module is on), HIGH = black
  if (izq == LOW && der == LOW) {
    adelante();
  }
  if (izq == HIGH && der == LOW) {
    izquierda();
  }
  if (izq == LOW && der == HIGH) {
    derecha();
  }
  if (izq == HIGH && der == HIGH) {
    parar();
  }
  Serial.print(izq);
  Serial.print(" ");
  Serial.println(der);
}

void adelante() {
  analogWrite(IN1, velocidad);
  digitalWrite(IN2, LOW);
  analogWrite(IN3, velocidad);
  digitalWrite(IN4, LOW);
}

void izquierda() {
  digitalWrite(IN1, LOW);
  analogWrite(IN2, velocidad);
  analogWrite(IN3, velocidad);
  digitalWrite(IN4, LOW);
}

void derecha() {
  analogWrite(IN1, velocidad);
  digitalWrite(IN2, LOW);
  digitalWrite(IN3, LOW);
  analogWrite(IN4, velocidad);
}

void parar() {
  digitalWrite(IN1, LOW);
  digitalWrite(IN2, LOW);
  digitalWrite(IN3, LOW);
  digitalWrite(IN4, LOW);
}
