/** Taylor coefficients along the orbit through the point of a probe, in balls.
 *
 *  Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, I.8; arithmetic of series: Arb. */
#ifndef TTC_SERIES_H
#define TTC_SERIES_H

#include "challenge/probe.h"

/** The coefficients of t^0 to t^order of an expression along the orbit that is at the probe's point at t = 0: out, shape
 *  (order + 1,). Every state of the model has an equation. Returns false if one of them has no value, or memory is out.
 *  Cost: order + 1 visits a node. */
bool ttc_series_along(ttc_probe *probe, const ttc_model *model, ttc_id id, long order, arb_ptr out);

#endif
