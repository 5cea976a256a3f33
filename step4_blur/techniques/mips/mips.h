// How many levels there are.
#ifndef STEP4_MIPS_H
#define STEP4_MIPS_H

enum { MIPS_MAX_LEVELS = 16 };

// Of a chain, level 0 among them, whose finest level has this size.
int mips_count(const int size[2]);

#endif
