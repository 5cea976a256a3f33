#define _GNU_SOURCE // program_invocation_name, readlink, realpath

#include "step1_shadowmap/base/files/tree.h"

#include <dirent.h> // opendir, readdir
#include <errno.h>  // program_invocation_name
#include <limits.h> // PATH_MAX
#include <stdio.h>  // snprintf
#include <stdlib.h> // realpath
#include <string.h> // strncmp, strrchr
#include <unistd.h> // readlink

// Without links in it. It may be gone: make has built another since.
static bool find_program(char path[FILE_NAME_BYTES])
{
    char found[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", path, FILE_NAME_BYTES - 1);
    if (length > 0) {
        path[length] = '\0';
        return true;
    }
    // Where there is no /proc.
    if (realpath(program_invocation_name, found) == NULL) {
        return false;
    }
    snprintf(path, FILE_NAME_BYTES, "%s", found);
    return true;
}

bool tree_find(char folder[FILE_NAME_BYTES])
{
    char step[FILE_NAME_BYTES + 32];
    bool found = false;
    folder[0] = '\0';
    if (!find_program(folder)) {
        return false;
    }
    while (!found && strrchr(folder, '/') != NULL) {
        *strrchr(folder, '/') = '\0';
        snprintf(step, sizeof step, "%s/step1_shadowmap", folder);
        found = file_is_directory(step);
    }
    return found;
}

bool tree_is_like(const char *folder)
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
