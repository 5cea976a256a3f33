// Scenes in parallel light, to be looked at; their truth is ray cast.
#include "step1_shadowmap/base/scenes/build.h"

#include <math.h> // cos, fmax, round, sin, sqrt

#include "step1_shadowmap/base/scene/dvec.h" // RADIANS

// The values of the scenes' keys, by place.
enum { THIN_THICKNESS };
enum { FENCE_PICKETS };
enum { CROWD_TRIANGLES };
enum { AVENUE_WALK, AVENUE_TURN, AVENUE_ASIDE, AVENUE_TILT };

void scene_build_thin(Scene *scene, const double values[])
{
    const double eye[3] = {0.4, 2.0, 3.6};
    const double target[3] = {0.1, 0.35, 0};
    scene_set_camera(scene, eye, target, 34);
    scene_set_light(scene, 0.55, -0.7, -0.25);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    const double wall[3] = {values[THIN_THICKNESS], 1.0, 1.6};
    const double left[3] = {-0.6, 0.5, 0};
    object_set_albedo(scene_add_object(scene, "wall", box, wall, left), 0.25f,
                      0.42f, 0.62f);
    const double block[3] = {0.6, 0.25, 0.6};
    const double right[3] = {0.7, 0.125, 0.4};
    object_set_albedo(scene_add_object(scene, "block", box, block, right),
                      0.72f, 0.30f, 0.16f);
}

// Pickets with gaps as wide as they are.
void scene_build_fence(Scene *scene, const double values[])
{
    const double eye[3] = {0.6, 1.9, 3.4};
    const double target[3] = {0.1, 0.3, 0};
    scene_set_camera(scene, eye, target, 34);
    scene_set_light(scene, 0.35, -0.6, 0.5);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    int count = (int)values[FENCE_PICKETS];
    double pitch = 2.4 / count;
    const double picket[3] = {0.5 * pitch, 0.8, 0.5 * pitch};
    for (int i = 0; i < count; i++) {
        const double place[3] = {-1.2 + (i + 0.5) * pitch, 0.4, -0.3};
        object_set_albedo(scene_add_object(scene, "picket", box, picket, place),
                          0.16f, 0.20f, 0.24f);
    }
}

// Two rows of columns along a road that leads away from the camera.
void scene_build_avenue(Scene *scene, const double values[])
{
    double angle = RADIANS(values[AVENUE_TURN]);
    const double eye[3] = {0.8 + values[AVENUE_ASIDE], 1.7,
                           4.0 - values[AVENUE_WALK]};
    const double ahead[3] = {-1.2, -0.6, -14};
    // Up and down by turning the target about the eye, before the turn.
    double tilt = RADIANS(values[AVENUE_TILT]);
    double up = cos(tilt) * ahead[1] - sin(tilt) * ahead[2];
    double along = sin(tilt) * ahead[1] + cos(tilt) * ahead[2];
    const double target[3] = {
        eye[0] + cos(angle) * ahead[0] - sin(angle) * along, eye[1] + up,
        eye[2] + sin(angle) * ahead[0] + cos(angle) * along};
    scene_set_camera(scene, eye, target, 50);
    scene->camera.reach = 130; // past the last column
    scene_set_light(scene, 0.7, -0.6, -0.35);
    Object *ground =
        scene_add_floor(scene, scene_add_mesh(scene, mesh_tiles(30)));
    ground->transform[0][0] = ground->transform[2][2] = 300;
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    const double column[3] = {0.4, 3.2, 0.4};
    for (int i = 0; i < 96; i++) {
        const double place[3] = {i % 2 ? 2.2 : -2.2, 1.6,
                                 -2.5 * (double)(i / 2)};
        object_set_albedo(scene_add_object(scene, "column", box, column, place),
                          0.52f, 0.56f, 0.60f);
    }
}

// A square field of spheres that share the triangles between them.
void scene_build_crowd(Scene *scene, const double values[])
{
    enum { SIDE = 8 };
    const double eye[3] = {0.5, 4.2, 7.5};
    const double target[3] = {0, 0.2, 0.2};
    scene_set_camera(scene, eye, target, 36);
    scene_set_light(scene, 0.5, -0.75, -0.3);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    // A sphere of n segments has n (n - 2) triangles.
    double each = values[CROWD_TRIANGLES] / (SIDE * SIDE);
    int segments = (int)fmax(4, 2 * round(0.5 * (1 + sqrt(1 + each))));
    const Mesh *sphere = scene_add_mesh(scene, mesh_sphere(segments));
    const double size[3] = {0.3, 0.3, 0.3};
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double place[3] = {0.75 * (i % SIDE - 0.5 * (SIDE - 1)), 0.3,
                                 0.75 * (double)(i / SIDE) -
                                     0.375 * (SIDE - 1)};
        object_set_albedo(
            scene_add_object(scene, "sphere", sphere, size, place), 0.72f,
            0.30f, 0.16f);
    }
}
