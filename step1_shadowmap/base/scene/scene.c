#include "step1_shadowmap/base/scene/scene.h"

#include <stdlib.h> // strtod
#include <string.h> // memset, strchr, strcmp, strcspn, strncmp

#include "step1_shadowmap/base/system/die.h"        // die_usage
#include "step1_shadowmap/base/scene/scene_build.h" // scene_table

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

static void list_keys(FILE *file, const SceneKey keys[])
{
    for (int i = 0; i < SCENE_MAX_KEYS && keys[i].name; i++) {
        fprintf(file, "    %s=%g..%g (default %g)  %s\n", keys[i].name,
                keys[i].minimum, keys[i].maximum, keys[i].value, keys[i].help);
    }
}

void scene_list(FILE *file)
{
    const SceneEntry *entry;
    for (int i = 0; (entry = entry_at(i)) != NULL; i++) {
        fprintf(file, "%s  %s\n", entry->name, entry->help);
        list_keys(file, entry->keys);
    }
    if (more_keys[0].name != NULL) {
        fprintf(file, "every scene\n");
        list_keys(file, more_keys);
    }
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
static bool read_key(const SceneKey keys[], const char *text, double values[])
{
    size_t length = strcspn(text, "=,");
    for (int i = 0; i < SCENE_MAX_KEYS && keys[i].name; i++) {
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
                      double own[SCENE_MAX_KEYS], double more[SCENE_MAX_KEYS])
{
    for (int i = 0; i < SCENE_MAX_KEYS; i++) {
        own[i] = entry->keys[i].value;
        more[i] = more_keys[i].value;
    }
    const char *next = strchr(text, ':');
    while (next != NULL) {
        next++;
        if (!read_key(entry->keys, next, own) &&
            !read_key(more_keys, next, more)) {
            die_usage("--scene key '%s': '%s' has no such key; "
                      "see --list-scenes",
                      next, entry->name);
        }
        next = strchr(next, ',');
    }
}

void scene_create(Scene *scene, const char *text, const char *light)
{
    double own[SCENE_MAX_KEYS], more[SCENE_MAX_KEYS];
    const float sky[3] = {0.36f, 0.44f, 0.55f};
    const SceneEntry *entry = find_entry(text);
    read_keys(entry, text, own, more);
    memset(scene, 0, sizeof *scene);
    scene->name = entry->name;
    memcpy(scene->background, sky, sizeof sky);
    entry->build(scene, own);
    scene_change(scene, more, light);
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
