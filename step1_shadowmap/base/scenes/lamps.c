// Scenes in the light of a lamp: a spot and a point light.
#include "step1_shadowmap/base/scenes/build.h"

#include <math.h> // cos, sin

#include "step1_shadowmap/base/scene/dvec.h" // dvec_subtract, RADIANS

// The values of a scene's keys, by place.
enum { ROOM_TURN };

// A teapot on a pedestal between columns, before a folded curtain.
static void add_set(Scene *scene, const Mesh *box)
{
    const double boards[3] = {7, 0.3, 4.4};
    const double middle[3] = {0, 0, 0};
    object_set_albedo(scene_add_block(scene, "boards", box, boards, middle),
                      0.46f, 0.33f, 0.23f);
    const double slat[3] = {0.5, 3.4, 0.16};
    for (int i = 0; i < 13; i++) {
        const double place[3] = {0.5 * (i - 6), 0.3, i % 2 ? -1.9 : -1.76};
        object_set_albedo(scene_add_block(scene, "fold", box, slat, place),
                          0.55f, 0.12f, 0.13f);
    }
    const double pedestal[3] = {0.9, 0.7, 0.9};
    const double centre[3] = {0, 0.3, 0.2};
    object_set_albedo(scene_add_block(scene, "pedestal", box, pedestal, centre),
                      0.60f, 0.58f, 0.54f);
    const double column[3] = {0.26, 1.9, 0.26};
    for (int i = 0; i < 4; i++) {
        const double place[3] = {i % 2 ? 1.5 : -1.5, 0.3, i / 2 ? 0.7 : -0.7};
        object_set_albedo(scene_add_block(scene, "column", box, column, place),
                          0.62f, 0.60f, 0.57f);
    }
}

void scene_build_stage(Scene *scene, const double values[])
{
    (void)values;
    const double eye[3] = {-1.6, 2.5, 6.2};
    const double target[3] = {0.1, 1.1, 0};
    const double lamp[3] = {2.4, 4.6, 4.0};
    scene_set_camera(scene, eye, target, 36);
    scene_set_local_light(scene, LIGHT_SPOT, lamp, target, 6.4);
    scene->light.cone = RADIANS(24);
    for (int k = 0; k < 3; k++) {
        scene->light.ambient[k] *= 0.6f;
        scene->background[k] = 0.04f;
    }
    const Mesh *plane = scene_add_mesh(scene, mesh_plane());
    object_set_albedo(scene_add_floor(scene, plane), 0.20f, 0.20f, 0.22f);
    add_set(scene, scene_add_mesh(scene, mesh_box()));
    const double size[3] = {0.62, 0.62, 0.62};
    const double place[3] = {0, 0.97, 0.2};
    const Mesh *teapot = scene_add_mesh(scene, mesh_teapot(16));
    object_set_albedo(scene_add_object(scene, "teapot", teapot, size, place),
                      0.72f, 0.62f, 0.40f);
}

// Six slabs around 6 x 3 x 5 world units.
static void add_walls(Scene *scene, const Mesh *box)
{
    const double sizes[6][3] = {{0.2, 3.4, 5.4}, {0.2, 3.4, 5.4},
                                {6.4, 0.2, 5.4}, {6.4, 0.2, 5.4},
                                {6.4, 3.4, 0.2}, {6.4, 3.4, 0.2}};
    const double places[6][3] = {{-3.1, 1.5, 0}, {3.1, 1.5, 0},  {0, -0.1, 0},
                                 {0, 3.1, 0},    {0, 1.5, -2.6}, {0, 1.5, 2.6}};
    const float colors[6][3] = {{0.58f, 0.30f, 0.22f}, {0.26f, 0.40f, 0.50f},
                                {0.52f, 0.46f, 0.40f}, {0.66f, 0.65f, 0.62f},
                                {0.64f, 0.62f, 0.56f}, {0.64f, 0.62f, 0.56f}};
    for (int i = 0; i < 6; i++) {
        Object *wall =
            scene_add_object(scene, "wall", box, sizes[i], places[i]);
        object_set_albedo(wall, colors[i][0], colors[i][1], colors[i][2]);
    }
}

static void add_table(Scene *scene, const Mesh *box)
{
    const double top[3] = {1.5, 0.07, 0.9};
    const double place[3] = {0.5, 0.7, -0.9};
    object_set_albedo(scene_add_block(scene, "table", box, top, place), 0.46f,
                      0.33f, 0.23f);
    const double leg[3] = {0.08, 0.7, 0.08};
    for (int i = 0; i < 4; i++) {
        const double foot[3] = {0.5 + (i % 2 ? 0.66 : -0.66), 0,
                                -0.9 + (i / 2 ? 0.36 : -0.36)};
        object_set_albedo(scene_add_block(scene, "leg", box, leg, foot), 0.46f,
                          0.33f, 0.23f);
    }
    const double one[3] = {0.42, 0.42, 0.42};
    const double on_top[3] = {0.5, 0.75, -0.9};
    const Mesh *teapot = scene_add_mesh(scene, mesh_teapot(16));
    object_set_albedo(scene_add_object(scene, "teapot", teapot, one, on_top),
                      0.72f, 0.30f, 0.16f);
}

// A screen of slats, whose shadows run over two walls and the ceiling.
static void add_screen(Scene *scene, const Mesh *box)
{
    const double slat[3] = {0.06, 1.7, 0.06};
    for (int i = 0; i < 9; i++) {
        const double foot[3] = {-2.1 + 0.17 * i, 0, -0.75 - 0.07 * i};
        object_set_albedo(scene_add_block(scene, "slat", box, slat, foot),
                          0.24f, 0.18f, 0.14f);
    }
}

// Closed: wherever a filter goes wrong at a seam between the light's views,
// there is a wall to see it on.
void scene_build_room(Scene *scene, const double values[])
{
    double angle = RADIANS(values[ROOM_TURN]);
    const double eye[3] = {-2.3, 1.9, 2.35};
    const double target[3] = {0.45, 1.05, -1.2};
    double ahead[3];
    dvec_subtract(target, eye, ahead);
    const double turned[3] = {
        eye[0] + cos(angle) * ahead[0] - sin(angle) * ahead[2], target[1],
        eye[2] + sin(angle) * ahead[0] + cos(angle) * ahead[2]};
    const double lamp[3] = {-0.25, 1.75, -0.1};
    scene_set_camera(scene, eye, turned, 62);
    scene_set_local_light(scene, LIGHT_POINT, lamp, target, 1.5);
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    add_walls(scene, box);
    add_table(scene, box);
    add_screen(scene, box);
    const Mesh *sphere = scene_add_mesh(scene, mesh_sphere(48));
    const double ball[3] = {0.32, 0.32, 0.32};
    const double place[3] = {1.9, 0.32, 0.1};
    object_set_albedo(scene_add_object(scene, "ball", sphere, ball, place),
                      0.62f, 0.60f, 0.57f);
    const double shelf[3] = {0.3, 0.05, 1.8};
    const double on_wall[3] = {2.85, 1.7, -1.0};
    object_set_albedo(scene_add_object(scene, "shelf", box, shelf, on_wall),
                      0.46f, 0.33f, 0.23f);
}
