#include "step1_shadowmap/base/leave_out/stamp.h"

void stamp_add(uint64_t *stamp, const void *data, size_t bytes)
{
    const unsigned char *byte = data;
    for (size_t i = 0; i < bytes; i++) {
        *stamp = (*stamp ^ byte[i]) * 0x100000001b3;
    }
}
