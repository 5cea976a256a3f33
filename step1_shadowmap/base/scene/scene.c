#include "step1_shadowmap/base/scene/scene.h"

#include <math.h>   // cos, fmax, fmin, hypot, isfinite, INFINITY
#include <stdlib.h> // strtod
#include <string.h> // memset, strchr, strcmp, strcspn, strncmp

#include "step1_shadowmap/base/system/die.h" // die, die_usage
#include "step1_shadowmap/base/scene/dvec.h" // dvec_dot, dvec_subtract, RADIANS
#include "step1_shadowmap/base/scene/scene_table.h" // scene_table

enum { COMMON_KEYS = 3 };

// The keys of every scene. An elevation of 0 keeps the scene's own light.
enum { KEY_OFFSET, KEY_SCALE, KEY_ELEVATION };
static const SceneKey common_keys[COMMON_KEYS] = {
    {"offset", -1e8, 1e8, 0, "moves the world along x, y and z, world units"},
    {"scale", 1e-6, 1e6, 1, "scales the world about its origin"},
    {"elevation", 0, 90, 0,
     "of the light above the horizon, degrees; 0: the scene's own"},
};

static void list_keys(FILE *file, const SceneKey keys[], int count)
{
    for (int i = 0; i < count && keys[i].name; i++) {
        fprintf(file, "    %s=%g..%g (default %g)  %s\n", keys[i].name,
                keys[i].minimum, keys[i].maximum, keys[i].value, keys[i].help);
    }
}

void scene_list(FILE *file)
{
    for (const SceneEntry *entry = scene_table; entry->name; entry++) {
        fprintf(file, "%s  %s\n", entry->name, entry->help);
        list_keys(file, entry->keys, SCENE_MAX_KEYS);
    }
    fprintf(file, "every scene\n");
    list_keys(file, common_keys, COMMON_KEYS);
}

static const SceneEntry *find_entry(const char *text)
{
    size_t length = strcspn(text, ":");
    for (const SceneEntry *entry = scene_table; entry->name; entry++) {
        if (strlen(entry->name) == length &&
            strncmp(entry->name, text, length) == 0) {
            return entry;
        }
    }
    die_usage("--scene '%s': there is no such scene; see --list-scenes", text);
}

// Sets the key that "key=value" names, if it is among these.
static bool read_key(const SceneKey keys[], int count, const char *text,
                     double values[])
{
    size_t length = strcspn(text, "=,");
    for (int i = 0; i < count && keys[i].name; i++) {
        if (strlen(keys[i].name) != length ||
            strncmp(keys[i].name, text, length) != 0) {
            continue;
        }
        const char *number = text + length + (text[length] == '=' ? 1 : 0);
        char *end = NULL;
        double value = strtod(number, &end);
        if (end == number || (*end != ',' && *end != '\0') ||
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
                      double own[SCENE_MAX_KEYS], double common[COMMON_KEYS])
{
    for (int i = 0; i < SCENE_MAX_KEYS; i++) {
        own[i] = entry->keys[i].value;
    }
    for (int i = 0; i < COMMON_KEYS; i++) {
        common[i] = common_keys[i].value;
    }
    const char *next = strchr(text, ':');
    while (next != NULL) {
        next++;
        if (!read_key(entry->keys, SCENE_MAX_KEYS, next, own) &&
            !read_key(common_keys, COMMON_KEYS, next, common)) {
            die_usage("--scene key '%s': '%s' has no such key; "
                      "see --list-scenes",
                      next, entry->name);
        }
        next = strchr(next, ',');
    }
}

static const char *const kind_names[] = {[LIGHT_DIRECTIONAL] = "directional",
                                         [LIGHT_SPOT] = "spot",
                                         [LIGHT_POINT] = "point"};

const char *light_kind_name(LightKind kind)
{
    return kind_names[kind];
}

static LightKind find_kind(const char *name)
{
    for (int kind = LIGHT_DIRECTIONAL; kind <= LIGHT_POINT; kind++) {
        if (strcmp(kind_names[kind], name) == 0) {
            return (LightKind)kind;
        }
    }
    die_usage("--light '%s': allowed are directional, spot, point", name);
}

static double distance_between(const double a[3], const double b[3])
{
    double offset[3];
    dvec_subtract(a, b, offset);
    return sqrt(dvec_dot(offset, offset));
}

// A light that has a direction gets the place that the other kinds need:
// `distance` before what the camera looks at.
static void place_light(Scene *scene, double distance)
{
    Light *light = &scene->light;
    for (int k = 0; k < 3; k++) {
        light->position[k] =
            scene->camera.target[k] - distance * light->direction[k];
    }
    light->reference = distance;
}

static void replace_light(Scene *scene, LightKind kind)
{
    Light *light = &scene->light;
    if (kind == light->kind) {
        return;
    }
    if (light->kind == LIGHT_DIRECTIONAL) {
        place_light(scene, distance_between(scene->camera.position,
                                            scene->camera.target));
    }
    light->kind = kind;
    light->cone = light->cone > 0 ? light->cone : RADIANS(32);
    light->near = light->far = 0; // of another measure of depth
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

// A spot or point light is raised about what the camera looks at.
static void raise_scene_light(Scene *scene, double degrees)
{
    raise_light(&scene->light, degrees);
    if (scene->light.kind != LIGHT_DIRECTIONAL) {
        place_light(scene, distance_between(scene->light.position,
                                            scene->camera.target));
    }
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
    move_point(scene->light.position, scale, offset);
    scene->light.reference *= scale;
    scene->camera.reach *= scale;
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

// Widens a box by an object, in world space.
static void include_object(const Object *object, double low[3], double high[3])
{
    for (size_t i = 0; i < object->mesh->vertex_count; i++) {
        const float *p = object->mesh->vertices[i].position;
        for (int row = 0; row < 3; row++) {
            const double *m = object->transform[row];
            double x = m[0] * (double)p[0] + m[1] * (double)p[1] +
                       m[2] * (double)p[2] + m[3];
            low[row] = fmin(low[row], x);
            high[row] = fmax(high[row], x);
        }
    }
}

// How far the camera is from the far end of the box of the casters, or of
// everything if nothing casts: there all shadows are within reach.
static double distance_to_all(const Scene *scene)
{
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    double middle[3];
    bool any = false;
    for (int i = 0; i < scene->object_count; i++) {
        any = any || scene->objects[i].casts;
    }
    for (int i = 0; i < scene->object_count; i++) {
        if (scene->objects[i].casts || !any) {
            include_object(&scene->objects[i], low, high);
        }
    }
    for (int k = 0; k < 3; k++) {
        middle[k] = 0.5 * (low[k] + high[k]);
    }
    return distance_between(scene->camera.position, middle) +
           0.5 * distance_between(low, high);
}

// One vertex that is no number would spread over all that is fitted to it.
static void check_object(const Scene *scene, const Object *object)
{
    for (size_t i = 0; i < object->mesh->vertex_count; i++) {
        const MeshVertex *vertex = &object->mesh->vertices[i];
        for (int k = 0; k < 3; k++) {
            if (!isfinite(vertex->position[k]) ||
                !isfinite(vertex->normal[k])) {
                die("scene %s: object '%s': vertex %zu is not finite: mend its "
                    "mesh, or leave it out",
                    scene->name, object->name, i);
            }
        }
    }
}

void scene_create(Scene *scene, const char *text, const char *light)
{
    double own[SCENE_MAX_KEYS];
    double common[COMMON_KEYS];
    const SceneEntry *entry = find_entry(text);
    read_keys(entry, text, own, common);
    memset(scene, 0, sizeof *scene);
    scene->name = entry->name;
    const float sky[3] = {0.36f, 0.44f, 0.55f};
    memcpy(scene->background, sky, sizeof sky);
    entry->build(scene, own);
    for (int i = 0; i < scene->object_count; i++) {
        check_object(scene, &scene->objects[i]);
    }
    if (common[KEY_ELEVATION] > 0) {
        raise_scene_light(scene, common[KEY_ELEVATION]);
    }
    if (light != NULL) {
        replace_light(scene, find_kind(light));
    }
    move_world(scene, common[KEY_SCALE], common[KEY_OFFSET]);
    if (scene->camera.reach == 0) {
        scene->camera.reach = 1.1 * distance_to_all(scene);
    }
}

void scene_destroy(Scene *scene)
{
    for (int i = 0; i < scene->mesh_count; i++) {
        mesh_destroy(&scene->meshes[i]);
    }
    memset(scene, 0, sizeof *scene);
}

void draw_list_all(DrawList *list, const Scene *scene)
{
    list->count = scene->object_count;
    for (int i = 0; i < scene->object_count; i++) {
        list->objects[i] = i;
    }
}
