// The version of the library: its only source. CMake reads it from here.
#pragma once

#define IMBIBE_VERSION_MAJOR 0
#define IMBIBE_VERSION_MINOR 1
#define IMBIBE_VERSION_PATCH 0
