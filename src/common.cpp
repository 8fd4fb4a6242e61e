// For the library imbibe::core: what is the same for scenes of all dimensions and numbers: checks, files, eigenvalues.
#define IMBIBE_CORE_SOURCE
#include <imbibe/monitor/guard.hpp>
#include <imbibe/monitor/progress.hpp>
#include <imbibe/output/run_folder.hpp>
#include <imbibe/output/vtk_series.hpp>
#include <imbibe/solid/artificial_stress.hpp>
#include <imbibe/solver/describe.hpp>
#include <imbibe/solver/scene_watch.hpp>
#include <imbibe/solver/warnings.hpp>
