// Scenes at the limits of what numbers can hold, or where the answer needs a
// choice. `make stability` measures what becomes of them.
#include "step1_shadowmap/base/scenes/build.h"

#include <math.h> // atan, fmin, tan, INFINITY, NAN

#include "step1_shadowmap/base/system/die.h" // allocate
#include "step1_shadowmap/base/scene/dvec.h" // RADIANS

// The values of a scene's keys, by place.
enum { LAMP_RATIO, LAMP_CONE };
enum { CUT_NEAR, CUT_FAR };
enum { STIFF_GAP, STIFF_ASIDE };
enum { BROKEN_VERTEX };

static void paint_caster(Object *object)
{
    object_set_albedo(object, 0.72f, 0.30f, 0.16f);
}

// A spot light of any cone, whose map begins `ratio` times nearer than it ends.
// A plate's edge crosses the middle of the cone, and the picture is as large as
// what the cone lights.
void scene_build_lamp(Scene *scene, const double values[])
{
    const double far = 20; // the floor's corners are nearer
    const double lamp[3] = {1.5, 9, 1};
    const double target[3] = {0, 0, 0};
    const double eye[3] = {-2.5, 6, 5};
    const double lamp_distance = 9.2;
    const double eye_distance = 8.2;
    double half = RADIANS(0.5 * values[LAMP_CONE]);
    double lit = fmin(1.3 * lamp_distance * tan(half), 4);
    scene_set_camera(scene, eye, target,
                     2 * atan(lit / eye_distance) / RADIANS(1));
    scene_set_local_light(scene, LIGHT_SPOT, lamp, target, lamp_distance);
    scene->light.cone = half;
    scene->light.near = far / values[LAMP_RATIO];
    scene->light.far = far;
    Object *ground =
        scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    ground->transform[0][0] = ground->transform[2][2] = 20;
    // Its edge is where the axis is half-way down.
    const double size[3] = {2, 0.01, 2};
    const double middle[3] = {0.75 - 1, 4.5, 0.5};
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    paint_caster(scene_add_object(scene, "plate", box, size, middle));
}

// A lamp in a closed box: all that is seen from outside is in its shadow.
void scene_build_enclosed(Scene *scene, const double values[])
{
    (void)values;
    const double lamp[3] = {0.1, 0.8, -0.1};
    const double target[3] = {0, 0.2, 0};
    scene_set_default_view(scene);
    scene_set_local_light(scene, LIGHT_POINT, lamp, target, 1.5);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const double size[3] = {0.8, 0.8, 0.8};
    const double middle[3] = {0, 0.7, 0};
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    paint_caster(scene_add_object(scene, "case", box, size, middle));
}

// The camera is where the light is, and sees no shadow.
void scene_build_headlamp(Scene *scene, const double values[])
{
    (void)values;
    scene_build_teapot(scene);
    const Camera *camera = &scene->camera;
    scene_set_local_light(scene, LIGHT_SPOT, camera->position, camera->target,
                          5.5);
    scene->light.cone = RADIANS(30);
}

// Camera and light look straight down, along both of their up vectors.
void scene_build_overhead(Scene *scene, const double values[])
{
    (void)values;
    scene_build_teapot(scene);
    const double eye[3] = {0, 6, 0};
    const double target[3] = {0, 0, 0};
    scene_set_camera(scene, eye, target, 38);
    scene_set_light(scene, 0, -1, 0);
}

// A rug that lies exactly in the floor: two surfaces at one depth.
void scene_build_coplanar(Scene *scene, const double values[])
{
    (void)values;
    scene_set_default_view(scene);
    const Mesh *plane = scene_add_mesh(scene, mesh_plane());
    scene_add_floor(scene, plane);
    const double size[3] = {2, 1, 1.4};
    const double middle[3] = {0, 0, 0};
    paint_caster(scene_add_object(scene, "rug", plane, size, middle));
}

static void add_vertex(Mesh *mesh, float x, float y, float z)
{
    mesh->vertices[mesh->vertex_count++] =
        (MeshVertex){.position = {x, y, z}, .normal = {0, 0, 1}};
}

static void add_triangle(Mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *next = mesh->indices + mesh->index_count;
    next[0] = a;
    next[1] = b;
    next[2] = c;
    mesh->index_count += 3;
}

// An upright sail of one triangle, and three of no area: two corners at one
// place, all of them there, and three along a line.
static Mesh sail_mesh(void)
{
    Mesh mesh = {.vertices = allocate(4, sizeof(MeshVertex)),
                 .indices = allocate(12, sizeof(uint32_t))};
    add_vertex(&mesh, -0.5f, 0, 0);
    add_vertex(&mesh, 0.5f, 0, 0);
    add_vertex(&mesh, 0, 1, 0);
    add_vertex(&mesh, 0.25f, 0.5f, 0); // on the line from 1 to 2
    add_triangle(&mesh, 0, 1, 2);
    add_triangle(&mesh, 0, 0, 2);
    add_triangle(&mesh, 1, 1, 1);
    add_triangle(&mesh, 1, 3, 2);
    return mesh;
}

static void add_sail(Scene *scene, Mesh mesh)
{
    scene_set_default_view(scene);
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const double size[3] = {1.6, 1.2, 1};
    const double foot[3] = {0, 0, 0};
    const Mesh *sail = scene_add_mesh(scene, mesh);
    Object *object = scene_add_object(scene, "sail", sail, size, foot);
    paint_caster(object);
    // Towards the light, turned about the vertical.
    object->transform[0][0] = object->transform[2][2] = 0.6 * size[0];
    object->transform[0][2] = 0.8 * size[0];
    object->transform[2][0] = -0.8 * size[0];
}

void scene_build_slivers(Scene *scene, const double values[])
{
    (void)values;
    add_sail(scene, sail_mesh());
}

// A vertex that is no number, or infinite: scene_create refuses the scene.
void scene_build_broken(Scene *scene, const double values[])
{
    const float bad[] = {0, NAN, INFINITY};
    Mesh mesh = sail_mesh();
    mesh.vertices[2].position[0] = bad[(int)values[BROKEN_VERTEX]];
    add_sail(scene, mesh);
}

// A light whose depth range ends inside the scene at both ends: a tower reaches
// from before the near plane to behind the far plane, and the floor crosses it.
void scene_build_cut(Scene *scene, const double values[])
{
    scene_set_default_view(scene);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -10 * scene->light.direction[k];
    }
    scene->light.near = values[CUT_NEAR];
    scene->light.far = values[CUT_FAR];
    scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    const double size[3] = {0.5, 1.4, 0.5};
    const double foot[3] = {0, 0, 0};
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    paint_caster(scene_add_block(scene, "tower", box, size, foot));
}

// Two scales under one filter, all perpendicular to the light: a sheet `gap` of
// the depth range above the floor, and a second one 0.9 of it above that, whose
// edge runs over the first one's, or `aside` units away from there.
void scene_build_stiff(Scene *scene, const double values[])
{
    const double range = 10;
    const double eye[3] = {5.0, 5.5, 4.5};
    const double target[3] = {0.1, 0.2, 0.1};
    scene_set_camera(scene, eye, target, 24);
    scene_set_light(scene, -0.35, -0.9, -0.25);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -0.95 * range * scene->light.direction[k];
    }
    scene->light.far = range;
    const Mesh *plane = scene_add_mesh(scene, mesh_plane());
    const double middle[2] = {0, 0};
    const double large[2] = {40, 40};
    Object *ground = scene_add_facing_plane(scene, "floor", plane, 0.95 * range,
                                            middle, large, 0);
    ground->casts = false;
    const double size[2] = {2, 1.5};
    paint_caster(scene_add_facing_plane(scene, "near sheet", plane,
                                        (0.95 - values[STIFF_GAP]) * range,
                                        middle, size, 0.35));
    const double shift[2] = {0.75 + values[STIFF_ASIDE], 0};
    const double half[2] = {1, 1};
    paint_caster(scene_add_facing_plane(scene, "far sheet", plane,
                                        0.05 * range - values[STIFF_GAP], shift,
                                        half, 0.7));
}

// A millimetre on a kilometre, units being metres: the light's depth range is
// that of the whole floor, the map that of the speck.
void scene_build_speck(Scene *scene, const double values[])
{
    (void)values;
    const double eye[3] = {-0.003, 0.004, 0.006};
    const double target[3] = {0.0003, 0, 0};
    scene_set_camera(scene, eye, target, 30);
    scene_set_light(scene, 0.66, -0.60, -0.14);
    for (int k = 0; k < 3; k++) {
        scene->light.anchor[k] = -900 * scene->light.direction[k];
    }
    scene->light.far = 1000;
    Object *ground =
        scene_add_floor(scene, scene_add_mesh(scene, mesh_plane()));
    ground->transform[0][0] = ground->transform[2][2] = 1000;
    const double size[3] = {0.001, 0.001, 0.001};
    const double foot[3] = {0, 0, 0};
    const Mesh *box = scene_add_mesh(scene, mesh_box());
    paint_caster(scene_add_block(scene, "speck", box, size, foot));
}
