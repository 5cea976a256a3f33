// A mesh without its normals: where only the outline counts, corners that
// differ in nothing else are one vertex. No two of its positions have the same
// bits.

#include <stdlib.h> // free
#include <string.h> // memcmp, memcpy

#include "step1_shadowmap/base/picture/geometry.h" // Shape
#include "step1_shadowmap/base/system/die.h"       // allocate

// Where the search for a position begins. Multipliers spread neighbouring bits
// (Teschner and others, Optimized spatial hashing for collision detection,
// 2003).
static size_t hash(const float position[3])
{
    uint32_t bits[3];
    memcpy(bits, position, sizeof bits);
    return bits[0] * 73856093u ^ bits[1] * 19349663u ^ bits[2] * 83492791u;
}

// The place of a position in the shape, which it joins if it is not there.
// `slots` hold places plus 1, or 0 where they are free; there are 2^n of them,
// more than positions.
static uint32_t find_or_add(Shape *shape, uint32_t *slots, size_t slot_count,
                            const float position[3])
{
    size_t bytes = sizeof shape->positions[0];
    size_t slot = hash(position) & (slot_count - 1);
    while (slots[slot] != 0) {
        uint32_t place = slots[slot] - 1;
        if (memcmp(shape->positions[place], position, bytes) == 0) {
            return place;
        }
        slot = (slot + 1) & (slot_count - 1);
    }
    memcpy(shape->positions[shape->count], position, bytes);
    slots[slot] = (uint32_t)++shape->count;
    return slots[slot] - 1;
}

bool shape_of_mesh(const Mesh *mesh, Shape *result)
{
    size_t slot_count = 1;
    while (slot_count < 2 * mesh->vertex_count) {
        slot_count *= 2;
    }
    Shape shape = {.positions =
                       allocate(mesh->vertex_count, sizeof shape.positions[0]),
                   .indices = allocate(mesh->index_count, sizeof(uint32_t))};
    uint32_t *slots = allocate(slot_count, sizeof *slots);
    uint32_t *places = allocate(mesh->vertex_count, sizeof *places);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        places[i] =
            find_or_add(&shape, slots, slot_count, mesh->vertices[i].position);
    }
    for (size_t i = 0; i < mesh->index_count; i++) {
        shape.indices[i] = places[mesh->indices[i]];
    }
    free(places);
    free(slots);
    *result = shape;
    return true;
}
