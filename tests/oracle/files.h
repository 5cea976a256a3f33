// The check `files`.
#ifndef ORACLE_FILES_H
#define ORACLE_FILES_H

#include "tests/oracle/dump.h"
#include "tests/oracle/report.h"

// Every file that the step writes is there with its shape (else BadInput),
// finite, and in its range.
void check_files(const Run &run, Report &report);

#endif
