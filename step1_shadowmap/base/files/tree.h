// Where the tree is, whose files a program reads when it runs: found from the
// program's own place, so that a copy of the tree reads its own.
#ifndef BASE_TREE_H
#define BASE_TREE_H

#include <stdbool.h>

#include "step1_shadowmap/base/files/file.h" // FILE_NAME_BYTES

// The innermost folder around the program's file that holds step1_shadowmap/;
// false where there is none.
bool tree_find(char folder[FILE_NAME_BYTES]);

// Whether a folder is laid out as the tree: it holds a step's folder.
bool tree_is_like(const char *folder);

#endif
