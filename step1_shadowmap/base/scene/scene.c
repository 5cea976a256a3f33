#include "step1_shadowmap/base/scene/scene.h"

#include <math.h>   // cos, hypot, sin
#include <stdlib.h> // strtod
#include <string.h> // memset, strchr, strcmp, strcspn, strncmp

#include "step1_shadowmap/base/system/die.h"        // die_usage
#include "step1_shadowmap/base/scene/dvec.h"        // dvec_normalize, RADIANS
#include "step1_shadowmap/base/scene/scene_build.h" // scene_table

enum { COMMON_KEYS = 3 };

// The keys of every scene. An elevation of 0 keeps the scene's own light.
enum { KEY_OFFSET, KEY_SCALE, KEY_ELEVATION };
static const SceneKey common_keys[COMMON_KEYS] = {
    {"offset", -1e8, 1e8, 0, "moves the world along x, y and z, world units"},
    {"scale", 1e-6, 1e6, 1, "scales the world about its origin"},
    {"elevation", 0, 90, 0,
     "of the light above the horizon, degrees; 0: the scene's own"},
};

// The scene of this number, of both tables; NULL behind the last.
static const SceneEntry *entry_at(int number)
{
    int count = 0;
    while (scene_table[count].name != NULL) {
        count++;
    }
    const SceneEntry *entry =
        number < count ? &scene_table[number] : &more_scenes[number - count];
    return entry->name == NULL ? NULL : entry;
}

static void list_keys(FILE *file, const SceneKey keys[], int count)
{
    for (int i = 0; i < count && keys[i].name; i++) {
        fprintf(file, "    %s=%g..%g (default %g)  %s\n", keys[i].name,
                keys[i].minimum, keys[i].maximum, keys[i].value, keys[i].help);
    }
}

void scene_list(FILE *file)
{
    const SceneEntry *entry;
    for (int i = 0; (entry = entry_at(i)) != NULL; i++) {
        fprintf(file, "%s  %s\n", entry->name, entry->help);
        list_keys(file, entry->keys, SCENE_MAX_KEYS);
    }
    fprintf(file, "every scene\n");
    list_keys(file, common_keys, COMMON_KEYS);
}

static const SceneEntry *find_entry(const char *text)
{
    size_t length = strcspn(text, ":");
    const SceneEntry *entry;
    for (int i = 0; (entry = entry_at(i)) != NULL; i++) {
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
    if (common[KEY_ELEVATION] > 0) {
        raise_light(&scene->light, common[KEY_ELEVATION]);
    }
    scene_change_light(scene, common[KEY_ELEVATION] > 0, light);
    move_world(scene, common[KEY_SCALE], common[KEY_OFFSET]);
    scene_finish(scene);
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
