// A driver that crashes because of what the environment says of it.
#ifndef BASE_CRASH_H
#define BASE_CRASH_H

// Where the environment steers the OpenGL driver (GALLIUM_DRIVER and the like),
// a crash from here on ends the program with status 1 and one line that names
// these variables. Else a crash stays one.
void crash_explain(void);

#endif
