#include "step1_shadowmap/base/scene_table.h"

#include <math.h>   // cos, fmax, round, sin, sqrt
#include <string.h> // memcpy

#include "step1_shadowmap/base/die.h"  // die
#include "step1_shadowmap/base/dvec.h" // dvec_copy, dvec_frame, dvec_subtract

#define RADIANS(degrees) ((degrees)*0.017453292519943295)

// The values of a scene's keys, by place.
enum { THIN_THICKNESS };
enum { FENCE_PICKETS };
enum { CROWD_TRIANGLES };
enum { AVENUE_WALK, AVENUE_TURN };

static const Mesh *add_mesh(Scene *scene, Mesh mesh)
{
    if (scene->mesh_count == SCENE_MAX_MESHES) {
        die("more than %d meshes in a scene", SCENE_MAX_MESHES);
    }
    scene->meshes[scene->mesh_count] = mesh;
    return &scene->meshes[scene->mesh_count++];
}

// An object whose axes are scaled and which stands at a position.
static Object *add_object(Scene *scene, const char *name, const Mesh *mesh,
                          const double size[3], const double position[3])
{
    if (scene->object_count == SCENE_MAX_OBJECTS) {
        die("more than %d objects in a scene", SCENE_MAX_OBJECTS);
    }
    Object *object = &scene->objects[scene->object_count++];
    *object = (Object){.name = name,
                       .mesh = mesh,
                       .albedo = {0.6f, 0.6f, 0.6f},
                       .casts = true};
    for (int k = 0; k < 3; k++) {
        object->transform[k][k] = size[k];
        object->transform[k][3] = position[k];
    }
    return object;
}

static void set_albedo(Object *object, float red, float green, float blue)
{
    object->albedo[0] = red;
    object->albedo[1] = green;
    object->albedo[2] = blue;
}

static void set_light(Scene *scene, double x, double y, double z)
{
    Light *light = &scene->light;
    const double direction[3] = {x, y, z};
    const float radiance[3] = {0.92f, 0.88f, 0.80f};
    const float ambient[3] = {0.17f, 0.19f, 0.24f};
    dvec_copy(direction, light->direction);
    dvec_normalize(light->direction);
    memcpy(light->radiance, radiance, sizeof radiance);
    memcpy(light->ambient, ambient, sizeof ambient);
}

// A spot or point light that is aimed at a target; its radiance holds at a
// distance from it.
static void set_local_light(Scene *scene, LightKind kind,
                            const double position[3], const double target[3],
                            double reference)
{
    double aim[3];
    dvec_subtract(target, position, aim);
    set_light(scene, aim[0], aim[1], aim[2]);
    scene->light.kind = kind;
    dvec_copy(position, scene->light.position);
    scene->light.reference = reference;
}

// A plane perpendicular to the light, `along` further than the anchor and
// shifted within the plane; its sides are turned by `angle` (radians) about
// the light against the horizontal.
static Object *add_facing_plane(Scene *scene, const char *name,
                                const Mesh *mesh, double along,
                                const double shift[2], const double size[2],
                                double angle)
{
    const double hint[3] = {0, 1, 0};
    const Light *light = &scene->light;
    double right[3];
    double up[3];
    dvec_frame(light->direction, hint, right, up);
    const double one[3] = {1, 1, 1};
    Object *object = add_object(scene, name, mesh, one, light->anchor);
    for (int row = 0; row < 3; row++) {
        double x = cos(angle) * right[row] + sin(angle) * up[row];
        double z = sin(angle) * right[row] - cos(angle) * up[row];
        double *m = object->transform[row];
        m[0] = size[0] * x;
        m[1] = -light->direction[row]; // the plane's normal
        m[2] = size[1] * z;
        m[3] = light->anchor[row] + along * light->direction[row] +
               shift[0] * x + shift[1] * z;
    }
    return object;
}

static void set_camera(Scene *scene, const double position[3],
                       const double target[3], double degrees)
{
    Camera *camera = &scene->camera;
    dvec_copy(position, camera->position);
    dvec_copy(target, camera->target);
    camera->up[1] = 1;
    camera->fov_y = RADIANS(degrees);
}

static Object *add_floor(Scene *scene, const Mesh *plane)
{
    const double size[3] = {60, 1, 60};
    const double position[3] = {0, 0, 0};
    Object *ground = add_object(scene, "floor", plane, size, position);
    set_albedo(ground, 0.62f, 0.60f, 0.57f);
    ground->casts = false;
    return ground;
}

static void set_default_view(Scene *scene)
{
    const double eye[3] = {-0.55, 2.75, 4.6};
    const double target[3] = {0.12, 0.33, 0.05};
    set_camera(scene, eye, target, 32);
    set_light(scene, 0.66, -0.60, -0.14);
}

// A gate of thin bars: what aliases first in a shadow map.
static void add_gate(Scene *scene, const Mesh *box)
{
    const double post[3] = {0.035, 1.0, 0.035};
    for (int i = 0; i < 6; i++) {
        const double position[3] = {-1.62, 0.5, -0.35 + 0.22 * i};
        set_albedo(add_object(scene, "bar", box, post, position), 0.16f, 0.20f,
                   0.24f);
    }
    const double rail[3] = {0.035, 0.05, 1.25};
    const double place[3] = {-1.62, 0.975, 0.2};
    set_albedo(add_object(scene, "rail", box, rail, place), 0.16f, 0.20f,
               0.24f);
}

static void build_teapot(Scene *scene, const double values[])
{
    (void)values;
    set_default_view(scene);
    add_floor(scene, add_mesh(scene, mesh_plane()));
    const Mesh *box = add_mesh(scene, mesh_box());

    const double one[3] = {1.1, 1.1, 1.1};
    // The pot's bottom is domed: its edge is above its middle by 0.05.
    const double middle[3] = {0, -0.05, 0};
    const Mesh *teapot = add_mesh(scene, mesh_teapot(16));
    set_albedo(add_object(scene, "teapot", teapot, one, middle), 0.72f, 0.30f,
               0.16f);
    const double wall[3] = {0.14, 1.0, 2.2};
    const double behind[3] = {1.75, 0.5, -0.3};
    set_albedo(add_object(scene, "wall", box, wall, behind), 0.52f, 0.56f,
               0.60f);
    add_gate(scene, box);
}

// The floor at depth 0.9 of a range of 10 units, the occluder `gap` of the
// range above it. The light is along no axis of the world, and the occluder's
// sides along no axis of the map.
enum { EDGE_GAP };

static void build_edge(Scene *scene, const double values[])
{
    const double range = 10;
    const double eye[3] = {5.0, 5.5, 4.5};
    const double target[3] = {0.1, 0.5, 0.1};
    set_camera(scene, eye, target, 24);
    set_light(scene, -0.35, -0.9, -0.25);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -0.9 * range * scene->light.direction[k];
    }
    scene->light.far = range;
    const Mesh *plane = add_mesh(scene, mesh_plane());
    const double centre[2] = {0, 0};
    const double large[2] = {40, 40};
    Object *ground =
        add_facing_plane(scene, "floor", plane, 0.9 * range, centre, large, 0);
    set_albedo(ground, 0.62f, 0.60f, 0.57f);
    ground->casts = false;
    const double size[2] = {2, 1.5};
    Object *occluder =
        add_facing_plane(scene, "occluder", plane,
                         (0.9 - values[EDGE_GAP]) * range, centre, size, 0.35);
    set_albedo(occluder, 0.25f, 0.42f, 0.62f);
}

// Two occluders over a floor, all perpendicular to the light; the upper one
// ends above the middle of the lower one, whose shadow therefore contains an
// edge that it should not show. The upper gap is r times the lower one.
enum { BLEED_RATIO };

static void build_bleed(Scene *scene, const double values[])
{
    const double lower_gap = 0.6;
    const double upper_gap = values[BLEED_RATIO] * lower_gap;
    const double height = 1 + lower_gap + upper_gap;
    const double eye[3] = {6.2, 2.2, 3.2};
    const double target[3] = {0.1, 0.8, 0};
    set_camera(scene, eye, target, 28);
    set_light(scene, -0.12, -0.98, -0.08);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -height * scene->light.direction[k];
    }
    const Mesh *plane = add_mesh(scene, mesh_plane());
    const double centre[2] = {0, 0};
    const double large[2] = {40, 40};
    Object *ground =
        add_facing_plane(scene, "floor", plane, height, centre, large, 0);
    set_albedo(ground, 0.62f, 0.60f, 0.57f);
    ground->casts = false;
    const double aside[2] = {-0.5, 0};
    const double size[2] = {2, 2};
    set_albedo(add_facing_plane(scene, "lower", plane, height - lower_gap,
                                centre, size, 0.1),
               0.25f, 0.42f, 0.62f);
    set_albedo(add_facing_plane(scene, "upper", plane, 1, aside, size, 0.1),
               0.72f, 0.30f, 0.16f);
}

static void build_empty(Scene *scene, const double values[])
{
    (void)values;
    set_default_view(scene);
    add_floor(scene, add_mesh(scene, mesh_plane()));
}

static void build_thin(Scene *scene, const double values[])
{
    const double eye[3] = {0.4, 2.0, 3.6};
    const double target[3] = {0.1, 0.35, 0};
    set_camera(scene, eye, target, 34);
    set_light(scene, 0.55, -0.7, -0.25);
    add_floor(scene, add_mesh(scene, mesh_plane()));
    const Mesh *box = add_mesh(scene, mesh_box());
    const double wall[3] = {values[THIN_THICKNESS], 1.0, 1.6};
    const double left[3] = {-0.6, 0.5, 0};
    set_albedo(add_object(scene, "wall", box, wall, left), 0.25f, 0.42f, 0.62f);
    const double block[3] = {0.6, 0.25, 0.6};
    const double right[3] = {0.7, 0.125, 0.4};
    set_albedo(add_object(scene, "block", box, block, right), 0.72f, 0.30f,
               0.16f);
}

// Pickets with gaps as wide as they are.
static void build_fence(Scene *scene, const double values[])
{
    const double eye[3] = {0.6, 1.9, 3.4};
    const double target[3] = {0.1, 0.3, 0};
    set_camera(scene, eye, target, 34);
    set_light(scene, 0.35, -0.6, 0.5);
    add_floor(scene, add_mesh(scene, mesh_plane()));
    const Mesh *box = add_mesh(scene, mesh_box());
    int count = (int)values[FENCE_PICKETS];
    double pitch = 2.4 / count;
    const double picket[3] = {0.5 * pitch, 0.8, 0.5 * pitch};
    for (int i = 0; i < count; i++) {
        const double place[3] = {-1.2 + (i + 0.5) * pitch, 0.4, -0.3};
        set_albedo(add_object(scene, "picket", box, picket, place), 0.16f,
                   0.20f, 0.24f);
    }
}

static void build_grazing(Scene *scene, const double values[])
{
    (void)values;
    const double degrees = 2;
    set_default_view(scene);
    set_light(scene, cos(RADIANS(degrees)), -sin(RADIANS(degrees)), 0);
    add_floor(scene, add_mesh(scene, mesh_plane()));
}

// Two rows of columns along a road that leads away from the camera.
static void build_avenue(Scene *scene, const double values[])
{
    double angle = RADIANS(values[AVENUE_TURN]);
    const double eye[3] = {0.8, 1.7, 4.0 - values[AVENUE_WALK]};
    const double ahead[3] = {-1.2, -0.6, -14};
    const double target[3] = {
        eye[0] + cos(angle) * ahead[0] - sin(angle) * ahead[2],
        eye[1] + ahead[1],
        eye[2] + sin(angle) * ahead[0] + cos(angle) * ahead[2]};
    set_camera(scene, eye, target, 50);
    scene->camera.reach = 130; // past the last column
    set_light(scene, 0.7, -0.6, -0.35);
    Object *ground = add_floor(scene, add_mesh(scene, mesh_tiles(30)));
    ground->transform[0][0] = ground->transform[2][2] = 300;
    const Mesh *box = add_mesh(scene, mesh_box());
    const double column[3] = {0.4, 3.2, 0.4};
    for (int i = 0; i < 96; i++) {
        const double place[3] = {i % 2 ? 2.2 : -2.2, 1.6,
                                 -2.5 * (double)(i / 2)};
        set_albedo(add_object(scene, "column", box, column, place), 0.52f,
                   0.56f, 0.60f);
    }
}

// A square field of spheres that share the triangles between them.
static void build_crowd(Scene *scene, const double values[])
{
    enum { SIDE = 8 };
    const double eye[3] = {0.5, 4.2, 7.5};
    const double target[3] = {0, 0.2, 0.2};
    set_camera(scene, eye, target, 36);
    set_light(scene, 0.5, -0.75, -0.3);
    add_floor(scene, add_mesh(scene, mesh_plane()));
    // A sphere of n segments has n (n - 2) triangles.
    double each = values[CROWD_TRIANGLES] / (SIDE * SIDE);
    int segments = (int)fmax(4, 2 * round(0.5 * (1 + sqrt(1 + each))));
    const Mesh *sphere = add_mesh(scene, mesh_sphere(segments));
    const double size[3] = {0.3, 0.3, 0.3};
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double place[3] = {0.75 * (i % SIDE - 0.5 * (SIDE - 1)), 0.3,
                                 0.75 * (double)(i / SIDE) -
                                     0.375 * (SIDE - 1)};
        set_albedo(add_object(scene, "sphere", sphere, size, place), 0.72f,
                   0.30f, 0.16f);
    }
}

// The light shines straight up from below the floor: nothing that the camera
// sees faces it.
static void build_unlit(Scene *scene, const double values[])
{
    build_teapot(scene, values);
    const Mesh *box = scene->objects[scene->object_count - 1].mesh;
    scene->object_count = 1; // the floor
    const double size[3] = {0.8, 0.8, 0.8};
    const double place[3] = {0, 0.4, 0};
    set_albedo(add_object(scene, "block", box, size, place), 0.72f, 0.30f,
               0.16f);
    set_light(scene, 0, 1, 0);
}

// Everything that casts is behind the camera, and so is its shadow.
static void build_offstage(Scene *scene, const double values[])
{
    (void)values;
    set_default_view(scene);
    set_light(scene, 0.4, -0.7, 0.5);
    add_floor(scene, add_mesh(scene, mesh_plane()));
    const double size[3] = {1, 1, 1};
    const double behind[3] = {0, 0, 12};
    add_object(scene, "teapot", add_mesh(scene, mesh_teapot(16)), size, behind);
}

// A box that stands on a height.
static Object *add_block(Scene *scene, const char *name, const Mesh *box,
                         const double size[3], const double foot[3])
{
    const double middle[3] = {foot[0], foot[1] + 0.5 * size[1], foot[2]};
    return add_object(scene, name, box, size, middle);
}

// A teapot on a pedestal between columns, before a folded curtain.
static void add_set(Scene *scene, const Mesh *box)
{
    const double boards[3] = {7, 0.3, 4.4};
    const double middle[3] = {0, 0, 0};
    set_albedo(add_block(scene, "boards", box, boards, middle), 0.46f, 0.33f,
               0.23f);
    const double slat[3] = {0.5, 3.4, 0.16};
    for (int i = 0; i < 13; i++) {
        const double place[3] = {0.5 * (i - 6), 0.3, i % 2 ? -1.9 : -1.76};
        set_albedo(add_block(scene, "fold", box, slat, place), 0.55f, 0.12f,
                   0.13f);
    }
    const double pedestal[3] = {0.9, 0.7, 0.9};
    const double centre[3] = {0, 0.3, 0.2};
    set_albedo(add_block(scene, "pedestal", box, pedestal, centre), 0.60f,
               0.58f, 0.54f);
    const double column[3] = {0.26, 1.9, 0.26};
    for (int i = 0; i < 4; i++) {
        const double place[3] = {i % 2 ? 1.5 : -1.5, 0.3, i / 2 ? 0.7 : -0.7};
        set_albedo(add_block(scene, "column", box, column, place), 0.62f, 0.60f,
                   0.57f);
    }
}

static void build_stage(Scene *scene, const double values[])
{
    (void)values;
    const double eye[3] = {-1.6, 2.5, 6.2};
    const double target[3] = {0.1, 1.1, 0};
    const double lamp[3] = {2.4, 4.6, 4.0};
    set_camera(scene, eye, target, 36);
    set_local_light(scene, LIGHT_SPOT, lamp, target, 6.4);
    scene->light.cone = RADIANS(24);
    for (int k = 0; k < 3; k++) {
        scene->light.ambient[k] *= 0.6f;
        scene->background[k] = 0.04f;
    }
    const Mesh *plane = add_mesh(scene, mesh_plane());
    set_albedo(add_floor(scene, plane), 0.20f, 0.20f, 0.22f);
    add_set(scene, add_mesh(scene, mesh_box()));
    const double size[3] = {0.62, 0.62, 0.62};
    const double place[3] = {0, 0.97, 0.2};
    const Mesh *teapot = add_mesh(scene, mesh_teapot(16));
    set_albedo(add_object(scene, "teapot", teapot, size, place), 0.72f, 0.62f,
               0.40f);
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
        Object *wall = add_object(scene, "wall", box, sizes[i], places[i]);
        set_albedo(wall, colors[i][0], colors[i][1], colors[i][2]);
    }
}

static void add_table(Scene *scene, const Mesh *box)
{
    const double top[3] = {1.5, 0.07, 0.9};
    const double place[3] = {0.5, 0.7, -0.9};
    set_albedo(add_block(scene, "table", box, top, place), 0.46f, 0.33f, 0.23f);
    const double leg[3] = {0.08, 0.7, 0.08};
    for (int i = 0; i < 4; i++) {
        const double foot[3] = {0.5 + (i % 2 ? 0.66 : -0.66), 0,
                                -0.9 + (i / 2 ? 0.36 : -0.36)};
        set_albedo(add_block(scene, "leg", box, leg, foot), 0.46f, 0.33f,
                   0.23f);
    }
    const double one[3] = {0.42, 0.42, 0.42};
    const double on_top[3] = {0.5, 0.75, -0.9};
    const Mesh *teapot = add_mesh(scene, mesh_teapot(16));
    set_albedo(add_object(scene, "teapot", teapot, one, on_top), 0.72f, 0.30f,
               0.16f);
}

// A screen of slats, whose shadows run over two walls and the ceiling.
static void add_screen(Scene *scene, const Mesh *box)
{
    const double slat[3] = {0.06, 1.7, 0.06};
    for (int i = 0; i < 9; i++) {
        const double foot[3] = {-2.1 + 0.17 * i, 0, -0.75 - 0.07 * i};
        set_albedo(add_block(scene, "slat", box, slat, foot), 0.24f, 0.18f,
                   0.14f);
    }
}

// Closed: wherever a filter goes wrong at a seam between the light's views,
// there is a wall to see it on.
static void build_room(Scene *scene, const double values[])
{
    (void)values;
    const double eye[3] = {-2.3, 1.9, 2.35};
    const double target[3] = {0.45, 1.05, -1.2};
    const double lamp[3] = {-0.25, 1.75, -0.1};
    set_camera(scene, eye, target, 62);
    set_local_light(scene, LIGHT_POINT, lamp, target, 1.5);
    const Mesh *box = add_mesh(scene, mesh_box());
    add_walls(scene, box);
    add_table(scene, box);
    add_screen(scene, box);
    const Mesh *sphere = add_mesh(scene, mesh_sphere(48));
    const double ball[3] = {0.32, 0.32, 0.32};
    const double place[3] = {1.9, 0.32, 0.1};
    set_albedo(add_object(scene, "ball", sphere, ball, place), 0.62f, 0.60f,
               0.57f);
    const double shelf[3] = {0.3, 0.05, 1.8};
    const double on_wall[3] = {2.85, 1.7, -1.0};
    set_albedo(add_object(scene, "shelf", box, shelf, on_wall), 0.46f, 0.33f,
               0.23f);
}

const SceneEntry scene_table[] = {
    {"teapot",
     "a teapot on a floor, with a wall and thin bars",
     build_teapot,
     {{0}}},
    {"edge",
     "a rectangle above a floor, both perpendicular to the light",
     build_edge,
     {{"gap", 1e-7, 0.8, 0.1, "between them, of the depth range"}}},
    {"bleed",
     "two occluders above a floor: light bleeding",
     build_bleed,
     {{"r", 0.05, 50, 2, "upper gap over lower gap"}}},
    {"empty", "a floor and nothing that casts", build_empty, {{0}}},
    {"thin",
     "a wall thinner than a texel, and a block on a floor",
     build_thin,
     {{"thickness", 1e-4, 0.5, 0.004, "of the wall, world units"}}},
    {"fence",
     "pickets finer than a texel",
     build_fence,
     {{"pickets", 1, 400, 160, "along 2.4 world units"}}},
    {"grazing", "a light almost parallel to a floor", build_grazing, {{0}}},
    {"avenue",
     "a long view down two rows of columns",
     build_avenue,
     {{"walk", 0, 40, 0, "the camera's way down the avenue, world units"},
      {"turn", -60, 60, 0, "of the camera to the right, degrees"}}},
    {"stage", "a teapot on a stage in a spot light", build_stage, {{0}}},
    {"room", "a point light inside a closed room", build_room, {{0}}},
    {"crowd",
     "64 spheres on a floor: cost against size",
     build_crowd,
     {{"triangles", 1e3, 1e7, 2e5, "of all spheres together, about"}}},
    {"unlit",
     "a light turned away from all that is visible",
     build_unlit,
     {{0}}},
    {"offstage",
     "casters that no visible receiver can see",
     build_offstage,
     {{0}}},
    {.name = NULL},
};
