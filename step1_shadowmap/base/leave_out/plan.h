// What --plan prints: each pass, whether it is kept, and why.
#ifndef BASE_PLAN_H
#define BASE_PLAN_H

#include <stdbool.h>
#include <stddef.h> // size_t

enum { PLAN_MAX_ROWS = 96 };

typedef struct PlanRow {
    char pass[32];
    bool kept;
    char why[112];
    size_t texels; // that are not written
    size_t bytes;  // of these
} PlanRow;

typedef struct Plan {
    PlanRow rows[PLAN_MAX_ROWS];
    int count;
} Plan;

// Adds a row. The pass is named after a layer too, if that is not negative.
// `texels` are those that are not written, of `texel_bytes` each; `why` is a
// printf format.
void plan_add(Plan *plan, const char *pass, int layer, bool kept, size_t texels,
              size_t texel_bytes, const char *why, ...)
    __attribute__((format(printf, 7, 8)));

// Prints the table on stdout, the sums last, if that is asked for (--plan).
void plan_print(const Plan *plan, bool asked);

#endif
