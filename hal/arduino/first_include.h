// Is the first header of each source. gcc loads a precompiled header (Foo.h.gch) only for the first header,
// so it loads none from a sketch's or library's folder. Such a file is an image of the compiler's memory.
