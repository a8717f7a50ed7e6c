// Is included before the first line of each source. gcc then loads no precompiled header (Foo.h.gch) from a
// sketch's or library's folder. Such a file would be an image of the compiler's memory.
