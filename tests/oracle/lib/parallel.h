// Rows of a picture on all processors.
#ifndef ORACLE_PARALLEL_H
#define ORACLE_PARALLEL_H

#include <functional>

// Calls work(y) once for each y from 0 to rows - 1, on several threads; the
// order does not matter to the result as long as a row writes only its own.
void parallel_rows(int rows, const std::function<void(int)> &work);

#endif
