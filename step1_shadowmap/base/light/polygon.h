// Convex polygons in space, cut by planes.
#ifndef BASE_POLYGON_H
#define BASE_POLYGON_H

// A triangle gains at most a corner from each half-space that cuts it.
enum { POLYGON_MAX_CORNERS = 20 };

// Keeps what is in the half-space dot(normal, p) <= limit (Sutherland and
// Hodgman). Returns the new number of corners, 0 if nothing is left.
int polygon_clip(double polygon[][3], int count, const double normal[3],
                 double limit);

#endif
