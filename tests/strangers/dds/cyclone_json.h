#pragma once
#include <stdio.h>

#include "cyclone_types.h"

/// A message as JSON, field by field under ROS's names; numbers with all their digits, NaN as null.
/// Covariances are left out but for their diagonal.
void print_json(FILE* out, const struct cyclone_type* type, const void* message);
