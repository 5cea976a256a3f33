// The check `matrix`: positions, the light's view and the camera.
#ifndef ORACLE_MATRIX_H
#define ORACLE_MATRIX_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/interval.h"
#include "tests/oracle/lib/verdict.h"
#include "tests/oracle/dump/scene_table.h"

// receiver.exr is map_from_relative times position.exr.
void check_receiver(const Run &run, Report &report);

// Every depth t that 32-bit arithmetic may make of a relative position.
Interval receiver_depth(const MapView &view, const glm::dvec3 &p);

// The view follows from the scene's light and casters.
void check_view(const Run &run, const SceneTable &table, int layer,
                Report &report);

// The same for a spot or point light; check_view calls it.
void check_local_view(const Run &run, const SceneTable &table, int layer,
                      Report &report);

// With --soft, the borders are as wide as the light's size wants: half of one
// is the widest search, what the blur and the least disc read added, up to an
// eighth of the map.
void check_soft_border(const Run &run, Report &report);

// The same for one of several splits.
void check_split(const Run &run, const SceneTable &table, int layer,
                 Report &report);

// position.exr lies on the rays of the scene's camera.
void check_camera(const Run &run, const SceneTable &table, Report &report);

#endif
