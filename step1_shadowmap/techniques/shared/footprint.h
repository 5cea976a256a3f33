// How far apart neighbouring pixels are in the map.
#ifndef STEP1_FOOTPRINT_H
#define STEP1_FOOTPRINT_H

#include <stdbool.h>

// The shader file with vec4 footprint(Receiver), for a lookup that needs to
// know. Before it comes the one that defines to_right and to_above.
extern const char map_footprint_file[];
extern const char map_footprint_steps[];

// Whether the picture's lookup has that file, once the picture is there.
bool map_footprint_is_used(void);

#endif
