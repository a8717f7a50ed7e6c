// Included before the first line of each source, so that gcc loads no precompiled header (Foo.h.gch) which
// lies in a sketch's or a library's folder: such a file is an image of the compiler's memory.
