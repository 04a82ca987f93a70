/** All of the library for its users, from C and from C++: tools/docs/library.md says what is where.
 *
 *      #include <jellett.h>        // cc ... $(pkg-config --cflags --libs jellett)
 *
 *  In C every header may also be included by itself. C++ includes this one alone: it declares the functions as extern "C". */
#ifndef JLT_JELLETT_H
#define JLT_JELLETT_H

/* The headers of libc that those below include, which in C++ are not C's: they come before. */
#include <math.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#include "core/random.h"
#include "core/status.h"

#include "kernel/batch_isa.h"
#include "kernel/descriptor.h"
#include "kernel/instance.h"
#include "kernel/kernel.h"
#include "kernel/link.h"
#include "kernel/load.h"
#include "kernel/observed.h"
#include "kernel/region.h"
#include "kernel/units.h"
#include "kernel/way.h"

#include "integrate/batch.h"
#include "integrate/event.h"
#include "integrate/field.h"
#include "integrate/invariant.h"
#include "integrate/method.h"
#include "integrate/orbit.h"
#include "integrate/stepper.h"

#include "dynamics/branch.h"
#include "dynamics/chart.h"
#include "dynamics/chart_level.h"
#include "dynamics/chart_section.h"
#include "dynamics/continuation.h"
#include "dynamics/fates.h"
#include "dynamics/homoclinic.h"
#include "dynamics/lyapunov.h"
#include "dynamics/manifold.h"
#include "dynamics/map.h"
#include "dynamics/map_batch.h"
#include "dynamics/orbits.h"
#include "dynamics/periodic.h"
#include "dynamics/section.h"
#include "dynamics/section_batch.h"
#include "dynamics/section_points.h"
#include "dynamics/separation.h"
#include "dynamics/surface.h"
#include "dynamics/surface_crossing.h"
#include "dynamics/symmetric.h"
#include "dynamics/system.h"

#include "analysis/boxes.h"
#include "analysis/charpoly.h"
#include "analysis/deflation.h"
#include "analysis/density.h"
#include "analysis/family.h"
#include "analysis/linearization.h"
#include "analysis/transfer.h"
#include "analysis/transfer_finding.h"
#include "analysis/transfer_section.h"
#include "analysis/transfer_spectrum.h"

#include "top/top.h"

#include "scene/course.h"
#include "scene/handle.h"
#include "scene/plan.h"
#include "scene/tier.h"

#ifdef __cplusplus
}
#endif

#endif
