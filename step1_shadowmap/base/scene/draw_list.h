// Which objects a pass draws: what its view does not see is not on its list.
#ifndef BASE_DRAW_LIST_H
#define BASE_DRAW_LIST_H

#include "step1_shadowmap/base/scene/scene.h" // Scene

// Places in the scene's list of objects, in the order of drawing: where two
// surfaces are equally far, the first one drawn is the one that shows.
typedef struct DrawList {
    int objects[SCENE_MAX_OBJECTS];
    int count;
} DrawList;

// Every object of the scene.
void draw_list_all(DrawList *list, const Scene *scene);

// The same for a picture: what is drawn later and lies behind need not be
// shaded. So the objects come by the distance of their origins from the camera,
// and last the ground, which casts nothing and on which all of them stand.
void draw_list_nearest_first(DrawList *list, const Scene *scene);

#endif
