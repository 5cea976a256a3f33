// The scene that a text names, with the keys that it sets.
#include <stdlib.h> // strtod
#include <string.h> // strchr, strcspn, strlen, strncmp

#include "step1_shadowmap/base/scenes/build.h" // scene_table, more_keys
#include "step1_shadowmap/base/system/die.h"   // die_usage

static void list_keys(FILE *file, const SceneKey keys[])
{
    for (int i = 0; i < SCENE_MAX_KEYS && keys[i].name; i++) {
        fprintf(file, "    %s=%g..%g (default %g)  %s\n", keys[i].name,
                keys[i].minimum, keys[i].maximum, keys[i].value, keys[i].help);
    }
}

void more_scenes_list(FILE *file)
{
    for (const SceneEntry *entry = scene_table + 1; entry->name; entry++) {
        fprintf(file, "%s  %s\n", entry->name, entry->help);
        list_keys(file, entry->keys);
    }
    fprintf(file, "every scene\n");
    list_keys(file, more_keys);
}

// NULL: there is none.
static const SceneEntry *find_entry(const char *text)
{
    size_t length = strcspn(text, ":");
    for (const SceneEntry *entry = scene_table; entry->name; entry++) {
        if (strlen(entry->name) == length &&
            strncmp(entry->name, text, length) == 0) {
            return entry;
        }
    }
    return NULL;
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

bool more_scenes_create(Scene *scene, const char *text, const char *light)
{
    double own[SCENE_MAX_KEYS], more[SCENE_MAX_KEYS];
    const SceneEntry *entry = find_entry(text);
    if (entry == NULL) {
        return false;
    }
    read_keys(entry, text, own, more);
    scene->name = entry->name;
    entry->build(scene, own);
    scene_change(scene, more, light);
    return true;
}
