/* Headers beside the contract: how kernels write fused operations, and the table of ball-arithmetic kernels. */
#include "emit/emit.h"

void ttc_emit_arithmetic(ttc_text *text)
{
    ttc_text_add(text,
                 "/** Fused operations of generated kernels. Written by ttc; do not edit.\n"
                 " *\n"
                 " *  Where the target has a fused multiply-add (FP_FAST_FMA), it is used and rounds once; elsewhere a product and a\n"
                 " *  sum round twice, and the slow library function is never called. Either way the order of operations is as written:\n"
                 " *  compile with -ffp-contract=off, so that nothing else is fused. */\n"
                 "#ifndef JLT_KERNEL_ARITHMETIC_H\n"
                 "#define JLT_KERNEL_ARITHMETIC_H\n"
                 "\n"
                 "#include <math.h>\n"
                 "\n"
                 "#ifdef FP_FAST_FMA\n"
                 "#define JLT_FMA(a, b, c) fma((a), (b), (c))\n"
                 "#define JLT_FMS(a, b, c) fma((a), (b), -(c))\n"
                 "#define JLT_FNMA(a, b, c) fma(-(a), (b), (c))\n");
    ttc_text_add(text, "#else\n"
                       "#define JLT_FMA(a, b, c) ((a) * (b) + (c))\n"
                       "#define JLT_FMS(a, b, c) ((a) * (b) - (c))\n"
                       "#define JLT_FNMA(a, b, c) ((c) - (a) * (b))\n"
                       "#endif\n"
                       "\n"
                       "#endif\n");
}

void ttc_emit_ball_header(ttc_text *text)
{
    ttc_text_add(text,
                 "/** Kernels in ball arithmetic. Written by ttc; do not edit.\n"
                 " *\n"
                 " *  Each evaluates the table's expressions as they stand, without the optimizer, on unprepared parameters, and encloses\n"
                 " *  every value that its inputs enclose. A table serves all variants of its time and elimination: impose the variant's\n"
                 " *  substitutions on the parameters first. Outside the domain the enclosures are not finite. `out` may alias nothing. */\n"
                 "#ifndef JLT_KERNEL_BALL_H\n"
                 "#define JLT_KERNEL_BALL_H\n"
                 "\n"
                 "#if __has_include(<flint/arb.h>)\n"
                 "#include <flint/arb.h>\n"
                 "#include <flint/fmpq.h>\n"
                 "#else\n"
                 "#include <arb.h>\n"
                 "#include <flint/fmpq.h>\n"
                 "#endif\n"
                 "\n"
                 "typedef void (*jlt_ball_function)(arb_ptr out, arb_srcptr x, arb_srcptr params, slong prec);\n"
                 "\n");
    ttc_text_add(text,
                 "typedef struct jlt_ball_table {\n"
                 "    const char *model, *time, *elimination; /* \"\" for the model's own time, for all states */\n"
                 "    unsigned state_count, param_count;\n"
                 "    jlt_ball_function rhs, jacobian, divergence; /* shapes as in the descriptor */\n"
                 "    unsigned integral_count;                     /* all of the table, whatever their condition */\n"
                 "    const char *const *integral;                 /* their names */\n"
                 "    jlt_ball_function integral_values, integral_gradients;\n"
                 "    unsigned trace_count;      /* families of equilibria that have a trace; in the model's own time only */\n"
                 "    const char *const *trace;  /* names of the families */\n"
                 "    const jlt_ball_function *traces;\n"
                 "} jlt_ball_table;\n"
                 "\n"
                 "/* The exact rational \"p/q\", rounded outwards. */\n"
                 "void jlt_ball_rational(arb_t out, const char *digits, slong prec);\n"
                 "\n"
                 "#endif\n");
}

void ttc_emit_ball_support(ttc_text *text)
{
    ttc_text_add(text, "/* Written by ttc; do not edit. */\n"
                       "#include \"kernel_ball.h\"\n"
                       "\n"
                       "void jlt_ball_rational(arb_t out, const char *digits, slong prec)\n"
                       "{\n"
                       "    fmpq_t q;\n"
                       "    fmpq_init(q);\n"
                       "    if (fmpq_set_str(q, digits, 10) == 0) arb_set_fmpq(out, q, prec);\n"
                       "    else arb_indeterminate(out);\n"
                       "    fmpq_clear(q);\n"
                       "}\n");
}
