#pragma once

/// @file
/// Everything but convert.h (a host's own types) and print.h (streams).
#include <cyclone/body.h>
#include <cyclone/core.h>
#include <cyclone/fgen.h>
#include <cyclone/fixedstep.h>
#include <cyclone/massproperties.h>
#include <cyclone/precision.h>
#include <cyclone/version.h>
#include <cyclone/world.h>
