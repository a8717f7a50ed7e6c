// Defines names that a PC's C library has, but avr-libc lacks. A sketch for an Uno may define all of them.
#include <avr/wdt.h>

int open, close, send, connect, accept, bind, listen, kill, fork, pipe, sync, nice, brk, gamma, j0, j1, jn, yn, y1, rindex,
    bcopy, bzero, daemon, environ, optarg, stat, truncate, tan2, clock, exec, times, wait, sleep, usleep, pause, alarm,
    access, fsync, dup, basename, key, hash, search, insque, signgam, drem, logb, significand, mount;
byte getline, memfd_create, socket, shutdown, poll, epoll, mmap, error;

void setup() {
  Serial.begin(9600);
  wdt_enable(WDTO_1S);
  link();
}

void unlink(int a) { kill = a; }

void loop() {
  wdt_reset();
  write(read());
  unlink(3);
  if (unmount("x")) wdt_disable();
}

int read() { return 1; }
void write(int value) { Serial.println(value + y1 + environ + error); }
void link() {}
bool unmount(const char *) { return false; }

int freeMemory() {
  extern int __heap_start, *__brkval;
  int v;
  return (long)&v - (__brkval == 0 ? (long)&__heap_start : (long)__brkval);
}

void (*restart)(void) = 0;
