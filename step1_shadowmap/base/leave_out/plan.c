#include "step1_shadowmap/base/leave_out/plan.h"

#include <stdarg.h> // va_start
#include <stdio.h>  // printf, snprintf, vsnprintf

#include "step1_shadowmap/base/system/die.h"     // die
#include "step1_shadowmap/base/system/printed.h" // printed_check

void plan_add(Plan *plan, const char *pass, int layer, bool kept, size_t texels,
              size_t texel_bytes, const char *why, ...)
{
    if (plan->count == PLAN_MAX_ROWS) {
        die("more than %d rows in a plan", PLAN_MAX_ROWS);
    }
    PlanRow *row = &plan->rows[plan->count++];
    *row = (PlanRow){
        .kept = kept, .texels = texels, .bytes = texels * texel_bytes};
    if (layer < 0) {
        snprintf(row->pass, sizeof row->pass, "%s", pass);
    } else {
        snprintf(row->pass, sizeof row->pass, "%s, layer %d", pass, layer);
    }
    va_list arguments;
    va_start(arguments, why);
    vsnprintf(row->why, sizeof row->why, why, arguments);
    va_end(arguments);
}

void plan_print(const Plan *plan, bool asked)
{
    size_t texels = 0, bytes = 0;
    if (!asked) {
        return;
    }
    printf("%-22s %-9s %13s %13s  %s\n", "pass", "decision", "saved texels",
           "saved bytes", "why");
    for (int i = 0; i < plan->count; i++) {
        const PlanRow *row = &plan->rows[i];
        printf("%-22s %-9s %13zu %13zu  %s\n", row->pass,
               row->kept ? "kept" : "left out", row->texels, row->bytes,
               row->why);
        texels += row->texels;
        bytes += row->bytes;
    }
    printf("%-22s %-9s %13zu %13zu\n", "all", "", texels, bytes);
    printed_check();
}
