// stdout, which what a program prints has to reach to the last byte.
#ifndef BASE_PRINTED_H
#define BASE_PRINTED_H

// Call this before anything else. Where the program was started with stdin,
// stdout or stderr closed, the next file that it opens would take that place,
// and be printed into: something that cannot be printed to is put there. And
// printing to a program that no longer listens is an error as any other.
void printed_prepare(void);

// Dies if something that was printed on stdout did not get there: the disk is
// full, or nobody reads it.
void printed_check(void);

#endif
