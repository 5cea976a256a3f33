#include "step1_shadowmap/base/scene.h"

#include <math.h>   // cos, fabs, isfinite, sin
#include <stdlib.h> // strtod
#include <string.h> // memset, strchr, strcspn, strncmp

#include "step1_shadowmap/base/die.h"  // die, die_usage
#include "step1_shadowmap/base/dvec.h" // dvec_copy, dvec_frame, dvec_normalize

#define RADIANS(degrees) ((degrees)*0.017453292519943295)

enum { MAX_KEYS = 4, COMMON_KEYS = 3 };

typedef struct Key {
    const char *name;
    double minimum, maximum, value; // the value is the default
    const char *help;
} Key;

typedef struct SceneEntry {
    const char *name;
    const char *help;
    void (*build)(Scene *scene, const double values[]);
    Key keys[MAX_KEYS];
} SceneEntry;

// The keys of every scene. An elevation of 0 keeps the scene's own light.
enum { KEY_OFFSET, KEY_SCALE, KEY_ELEVATION };
static const Key common_keys[COMMON_KEYS] = {
    {"offset", -1e8, 1e8, 0, "moves the world along x, y and z, world units"},
    {"scale", 1e-6, 1e6, 1, "scales the world about its origin"},
    {"elevation", 0, 90, 0,
     "of the light above the horizon, degrees; 0: the scene's own"},
};

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

static const SceneEntry entries[] = {
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
};
enum { ENTRIES = sizeof entries / sizeof *entries };

static void list_keys(FILE *file, const Key keys[], int count)
{
    for (int i = 0; i < count && keys[i].name; i++) {
        fprintf(file, "    %s=%g..%g (default %g)  %s\n", keys[i].name,
                keys[i].minimum, keys[i].maximum, keys[i].value, keys[i].help);
    }
}

void scene_list(FILE *file)
{
    for (int i = 0; i < ENTRIES; i++) {
        fprintf(file, "%s  %s\n", entries[i].name, entries[i].help);
        list_keys(file, entries[i].keys, MAX_KEYS);
    }
    fprintf(file, "every scene\n");
    list_keys(file, common_keys, COMMON_KEYS);
}

static const SceneEntry *find_entry(const char *text)
{
    size_t length = strcspn(text, ":");
    for (int i = 0; i < ENTRIES; i++) {
        if (strlen(entries[i].name) == length &&
            strncmp(entries[i].name, text, length) == 0) {
            return &entries[i];
        }
    }
    die_usage("--scene '%s': there is no such scene; see --list-scenes", text);
}

// Sets the key that "key=value" names, if it is among these.
static bool read_key(const Key keys[], int count, const char *text,
                     double values[])
{
    size_t length = strcspn(text, "=,");
    for (int i = 0; i < count && keys[i].name; i++) {
        if (strlen(keys[i].name) != length || text[length] != '=' ||
            strncmp(keys[i].name, text, length) != 0) {
            continue;
        }
        char *end = NULL;
        double value = strtod(text + length + 1, &end);
        if (end == text + length + 1 || (*end != ',' && *end != '\0') ||
            !(value >= keys[i].minimum && value <= keys[i].maximum)) {
            die_usage("--scene key '%s': allowed are numbers from %g to %g",
                      text, keys[i].minimum, keys[i].maximum);
        }
        values[i] = value;
        return true;
    }
    return false;
}

static void read_keys(const SceneEntry *entry, const char *text,
                      double own[MAX_KEYS], double common[COMMON_KEYS])
{
    for (int i = 0; i < MAX_KEYS; i++) {
        own[i] = entry->keys[i].value;
    }
    for (int i = 0; i < COMMON_KEYS; i++) {
        common[i] = common_keys[i].value;
    }
    const char *next = strchr(text, ':');
    while (next != NULL) {
        next++;
        if (!read_key(entry->keys, MAX_KEYS, next, own) &&
            !read_key(common_keys, COMMON_KEYS, next, common)) {
            die_usage("--scene key '%s': '%s' has no such key; "
                      "see --list-scenes",
                      next, entry->name);
        }
        next = strchr(next, ',');
    }
}

static void raise_light(Light *light, double degrees)
{
    double x = light->direction[0];
    double z = light->direction[2];
    double length = hypot(x, z);
    // A light straight from above has no azimuth of its own: it gets +x.
    double azimuth[2] = {length > 0 ? x / length : 1,
                         length > 0 ? z / length : 0};
    light->direction[0] = cos(RADIANS(degrees)) * azimuth[0];
    light->direction[1] = -sin(RADIANS(degrees));
    light->direction[2] = cos(RADIANS(degrees)) * azimuth[1];
    dvec_normalize(light->direction);
}

static void move_point(double point[3], double scale, double offset)
{
    for (int k = 0; k < 3; k++) {
        point[k] = point[k] * scale + offset;
    }
}

static void move_world(Scene *scene, double scale, double offset)
{
    move_point(scene->camera.position, scale, offset);
    move_point(scene->camera.target, scale, offset);
    move_point(scene->light.anchor, scale, offset);
    scene->light.near *= scale;
    scene->light.far *= scale;
    for (int i = 0; i < scene->object_count; i++) {
        for (int row = 0; row < 3; row++) {
            double *m = scene->objects[i].transform[row];
            m[0] *= scale;
            m[1] *= scale;
            m[2] *= scale;
            m[3] = m[3] * scale + offset;
        }
    }
}

void scene_create(Scene *scene, const char *text)
{
    double own[MAX_KEYS];
    double common[COMMON_KEYS];
    const SceneEntry *entry = find_entry(text);
    read_keys(entry, text, own, common);
    memset(scene, 0, sizeof *scene);
    scene->name = entry->name;
    const float sky[3] = {0.36f, 0.44f, 0.55f};
    memcpy(scene->background, sky, sizeof sky);
    entry->build(scene, own);
    if (common[KEY_ELEVATION] > 0) {
        raise_light(&scene->light, common[KEY_ELEVATION]);
    }
    move_world(scene, common[KEY_SCALE], common[KEY_OFFSET]);
}

void scene_destroy(Scene *scene)
{
    for (int i = 0; i < scene->mesh_count; i++) {
        mesh_destroy(&scene->meshes[i]);
    }
    memset(scene, 0, sizeof *scene);
}
