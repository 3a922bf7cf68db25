#pragma once

/// @file
/// Every force generator, under its classic name.
#include <cyclone/aero.h>
#include <cyclone/buoyancy.h>
#include <cyclone/force.h>
#include <cyclone/propulsion.h>
#include <cyclone/water.h>
#include <cyclone/wind.h>
#include <cyclone/wing.h>
