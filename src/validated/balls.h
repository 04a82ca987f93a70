/** Includes Arb's headers, which lie beside FLINT 2 or within FLINT 3. */
#ifndef JLT_VALIDATED_BALLS_H
#define JLT_VALIDATED_BALLS_H

#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/arb.h>
#include <flint/arb_mat.h>
#else
#include <acb.h>
#include <arb.h>
#include <arb_mat.h>
#endif

#endif
