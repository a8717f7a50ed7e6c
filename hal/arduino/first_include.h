// An empty header that the build includes first in each source, to keep gcc from loading precompiled headers.
// gcc loads a precompiled header (Foo.h.gch) only for the first header of a source. A .gch file is an image
// of the compiler's memory. Such a file in the folder of a sketch or library could be harmful.
