// The folder that --shaders names.
#include <dirent.h> // opendir, readdir
#include <string.h> // strncmp

#include "step1_shadowmap/base/files/file.h" // file_check_shaders
#include "step1_shadowmap/base/system/die.h" // die_usage

// Whether a folder is laid out as the tree: it holds a step's folder.
static bool tree_is_like(const char *folder)
{
    bool found = false;
    DIR *entries = opendir(folder);
    for (struct dirent *entry = NULL;
         entries != NULL && !found && (entry = readdir(entries)) != NULL;) {
        found = strncmp(entry->d_name, "step", 4) == 0;
    }
    if (entries != NULL) {
        closedir(entries);
    }
    return found;
}

void file_check_shaders(const char *folder)
{
    if (folder != NULL && !file_is_directory(folder)) {
        die_usage("--shaders '%s': there is no such directory", folder);
    }
    if (folder != NULL && !tree_is_like(folder)) {
        die_usage("--shaders '%s': it holds no folder of a step; it has to be "
                  "laid out as the tree is",
                  folder);
    }
}
