// The check `files`.
#ifndef ORACLE_FILES_H
#define ORACLE_FILES_H

#include "tests/oracle/dump/dump.h"
#include "tests/oracle/lib/verdict.h"

// Every file that the step writes is there with its shape (else BadInput),
// finite, and in its range.
void check_files(const Run &run, Report &report);

#endif
