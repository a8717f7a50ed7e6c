// Is included before the first line of each source. So gcc does not load a precompiled header (Foo.h.gch)
// from a sketch's or library's folder, which would be an image of the compiler's memory.
