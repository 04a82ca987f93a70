/* Every mistake a table can hold, with the one line that must be said about it. HEAD stands for a table that is right, so
 * that the mistake is alone; its lines are counted in the places. */
#include "unit/check.h"

#include <stdio.h>
#include <stdlib.h>

#include "read/model.h"
#include "base/source.h"

#define HEAD "model t\nparam a\nstate x\nstate y\neq x = a*y\neq y = x\n" /* six lines */

typedef struct {
    const char *text;     /* a table */
    const char *expected; /* LINE:COLUMN: severity: message */
} mistake;

static const mistake mistakes[] = {
    /* text */
    { "", "1:1: error: the table is empty (expected 'model NAME')" },
    { "# nothing\n", "2:1: error: the table is empty (expected 'model NAME')" },
    { HEAD "let b = \xff\n", "7:9: error: a byte that is not UTF-8 (expected UTF-8 text)" },
    { HEAD "# \xc0\xaf overlong\n", "7:3: error: a byte that is not UTF-8 (expected UTF-8 text)" },
    { HEAD "# \xed\xa0\x80 surrogate\n", "7:3: error: a byte that is not UTF-8 (expected UTF-8 text)" },
    { "model t\r\nparam a\r\n", "1:8: error: a carriage return (expected lines that end in a line feed alone)" },
    { "\xef\xbb\xbfmodel t\n", "1:1: error: a byte order mark (expected none)" },
    { HEAD "title \"a\x1b[2Jb\"\n", "7:9: error: a control character (expected printable text)" },
    { HEAD "let \xc2\xb5 = 1\n", "7:5: error: a character outside ASCII (expected only in comments and in \"...\")" },
    { HEAD "let b = a $ x\n", "7:11: error: unexpected '$'" },
    { HEAD "let b = a**2\n", "7:10: error: unexpected '*' (a power is written ^)" },
    { HEAD "let b = a + .5\n", "7:13: error: unexpected '.' (a number opens with a digit: 0.5)" },
    { HEAD "title \"open\n", "7:7: error: a text is not closed (expected '\"' on the same line)" },
    { HEAD "param b [kg\n", "7:9: error: a unit is not closed (expected ']' on the same line)" },
    { HEAD "let aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa = 1\n",
      "7:5: error: a name of 64 characters (expected at most 63)" },

    /* records */
    { "param b\n" HEAD, "1:1: error: the table opens without its model (expected 'model NAME' first)" },
    { HEAD "model u\n", "7:1: error: a second model (expected one model a file)" },
    { HEAD "pram b\n", "7:1: error: 'pram' opens no record (expected a keyword, or an indented line that continues the "
                       "record above)" },
    { HEAD "+ a\n", "7:1: error: '+' opens no record (expected a keyword, or an indented line that continues the record "
                    "above)" },
    { HEAD "  pram b\n", "7:3: error: unexpected 'pram' (expected the end of the record)" },
    { HEAD "let b = a a\n", "7:11: error: unexpected 'a' (expected an operator before it, such as *, or the end of the record)" },
    { HEAD "let b = a, x\n", "7:10: error: unexpected ',' (expected the end of the record)" },
    { HEAD "let state = a\n", "7:5: error: 'state' is a keyword and names nothing (expected a name for the expression)" },
    { HEAD "let when = a\n", "7:5: error: 'when' is a keyword and names nothing (expected a name for the expression)" },
    { HEAD "let b = a + let\n", "7:13: error: 'let' is a keyword and names nothing (expected a number, a name or '(')" },
    { HEAD "let b =\nlet c = a\n", "7:8: error: the record ends too early (expected a number, a name or '(')" },
    { HEAD "let b = a +", "7:12: error: the table ends within a record (expected a number, a name or '(')" },
    { HEAD "title here\n", "7:7: error: unexpected 'here' (expected a text in quotes)" },
    { HEAD "title \"a\"\ntitle \"b\"\n", "8:1: error: a second title (expected one)" },

    /* numbers and expressions */
    { HEAD "let b = 2x\n", "7:10: error: malformed number (expected an operator between a number and a name, such as 2*x)" },
    { HEAD "let b = 1e\n", "7:10: error: malformed number (expected an operator between a number and a name, such as 2*x)" },
    { HEAD "let b = 1.\n", "7:11: error: malformed number (expected digits after the decimal point)" },
    { HEAD "let b = 1.5.2\n", "7:12: error: unexpected '.' (a number opens with a digit: 0.5)" },
    { HEAD "let b = 1e999999999\n", "7:9: error: the decimal exponent is too large (expected at most 999)" },
    { HEAD "let b = 1e-1000\n", "7:9: error: the decimal exponent is too large (expected at most 999)" },
    { HEAD "let b = a*-2\n", "7:11: error: unexpected '-' (expected a number, a name or '(')" },
    { HEAD "let b = + + a\n", "7:11: error: unexpected '+' (expected a number, a name or '(')" },
    { HEAD "let b = ()\n", "7:10: error: unexpected ')' (expected a number, a name or '(')" },
    { HEAD "let b = (a\n", "7:11: error: the table ends within a record (expected ')' after the expression in parentheses)" },
    { HEAD "let b = (a))\n", "7:12: error: unexpected ')' (expected the end of the record)" },
    { HEAD "let b = a^65\n", "7:11: error: the exponent is too large (expected at most 64)" },
    { HEAD "let b = a^-65\n", "7:12: error: the exponent is too large (expected at most 64)" },
    { HEAD "let b = a^99999999999999999999\n", "7:11: error: the exponent is too large (expected at most 64)" },
    { HEAD "let b = a^x\n", "7:11: error: unexpected 'x' (expected an integer exponent: roots and exponentials have records of "
                            "their own)" },
    { HEAD "let b = a^0.5\n", "7:11: error: unexpected '0.5' (expected an integer exponent: roots and exponentials have records "
                              "of their own)" },
    { HEAD "let b = a^(1/2)\n", "7:13: error: unexpected '/' (expected an integer exponent: roots and exponentials have records "
                                "of their own)" },
    { HEAD "let b = a^2^3\n", "7:12: error: unexpected '^' (expected parentheses around a power of a power)" },
    { HEAD "let b = (a^64)^64\n", "7:9: error: a power passes 256" },
    { HEAD "let b = ((2^64)^64)^64\n", "7:10: error: a number passes 4096 bits" },
    { HEAD "let b = a/0\n", "7:11: error: division by zero" },
    { HEAD "let b = a/(x - x)\n", "7:11: error: division by zero" },
    { HEAD "let b = 0^-1\n", "7:9: error: division by zero" },
    { HEAD "let b = sqrt(a)\n",
      "7:9: error: 'sqrt' is a keyword and names nothing (expected a name that its own record gives to it, "
      "such as 'root s = sqrt(1 - x^2)')" },
    { HEAD "let b = a*sin(x)\n",
      "7:11: error: 'sin' is a keyword and names nothing (expected a name that its own record gives to it, "
      "such as 'angle C S = cos(x) sin(x)')" },
    { HEAD "let b = a(x)\n", "7:10: error: unexpected '(' (expected an operator: names stand for quantities, not for "
                             "functions)" },

    { HEAD "let b = log(x)\n", "7:12: error: unexpected '(' (expected an operator: a function gets a name by its own record, such "
                               "as 'exp e = exp(x)')" },

    /* names */
    { HEAD "let b = q\n", "7:9: error: unknown name 'q' (expected a name defined above)" },
    { HEAD "let omega = a\nlet b = omga\n", "8:9: error: unknown name 'omga' (expected a name defined above; did you mean "
                                            "'omega'?)" },
    { HEAD "let b = b\n", "7:9: error: 'b' stands for itself (expected names that stand above)" },
    { HEAD "let b = c\nlet c = b\n", "7:9: error: 'c' is used before line 8 defines it (expected names that stand above, so "
                                     "that no circle arises)" },
    { HEAD "param a\n", "7:7: error: 'a' is defined twice (first in line 2)" },
    { HEAD "let x = a\n", "7:5: error: 'x' is defined twice (first in line 3)" },
    { HEAD "let b = lambda\n", "7:9: error: 'lambda' is the indeterminate of 'charpoly' and means nothing elsewhere (expected "
                               "another name)" },
    { HEAD "param b\n", "7:7: warning: the parameter 'b' is never used" },
    { HEAD "let b = a\n", "7:5: warning: the let 'b' is never used" },
    { HEAD "root r = sqrt(x^2 + 1)\n", "7:6: warning: the root 'r' is never used" },
    { HEAD "angle c s = cos(x) sin(x)\n", "7:7: warning: the angle 'c' is never used" },
    { HEAD "param b\nintegral F = x/b\n", "8:10: warning: the integral 'F' divides by the parameter 'b', which may be 0, "
                                             "where no kernel could be prepared (expected 'param b != 0', or '> 0')" },
    { HEAD "param b\nlet c = y*b^2 - b*x\nintegral F = x/(b + 2*x*c)\n",
      "9:10: warning: the integral 'F' divides by the parameter 'b', which may be 0, where no kernel could be prepared "
      "(expected 'param b != 0', or '> 0')" },

    /* param, state, root, angle, default */
    { HEAD "param b < 0\n", "7:9: error: unexpected '<' (a condition is written with >: 1 - x > 0)" },
    { HEAD "state z > 0\neq z = a\n", "7:9: error: unexpected '>' (expected the interval of a state, as in 'in (0, inf)')" },
    { HEAD "param b > 1\n", "7:11: error: unexpected '1' (expected 0: a parameter is > 0, >= 0 or != 0)" },
    { HEAD "param b \"m\" [kg]\n", "7:13: error: unexpected unit (expected the end of the record)" },
    { HEAD "state z\n", "7:7: error: the state 'z' has no equation (expected 'eq z = ...')" },
    { "model t\nparam a\n", "1:1: error: the model has no state (expected at least one)" },
    { "model t\nstate x in (0, 1\neq x = x\n", "2:17: error: the record ends too early (expected ')' after the upper end)" },
    { "model t\nstate x in (1, 0)\neq x = x\n", "2:12: error: the interval is empty (expected its lower end first)" },
    { "model t\nstate x in (0, -inf)\neq x = x\n", "2:16: error: no number is below it (expected 'inf' as the upper end)" },
    { "model t\nstate x\nstate y in (0, x)\neq x = x\neq y = x\n",
      "3:12: error: the interval depends on a state (expected numbers and parameters)" },
    { HEAD "root r = x\n", "7:10: error: unexpected 'x' (expected 'sqrt' after '=')" },
    { HEAD "root r = sqrt(-2)\n", "7:10: error: the root of a number that is not positive" },
    { HEAD "root r = sqrt(9/4)\n", "7:10: error: the root of a square number (expected the rational number it is)" },
    { HEAD "root r = sqrt(x + 1)\nroot q = sqrt(1 + x)\n", "8:10: error: the same root as 'r' (expected one name for it)" },
    { HEAD "angle c s = cos(x) sin(y)\n", "7:20: error: cosine and sine of different angles (expected the same)" },
    { HEAD "angle c = cos(x) sin(x)\n", "7:9: error: unexpected '=' (expected the name of the sine)" },
    { HEAD "exp e = x\n", "7:9: error: unexpected 'x' (expected 'exp' after '=')" },
    { HEAD "exp e = exp(0)\n", "7:9: error: the exponential of zero (expected the number 1)" },
    { HEAD "exp e = exp(2*x)\nexp f = exp(x + x)\n", "8:9: error: the same exponential as 'e' (expected one name for it)" },
    { HEAD "exp e = exp(e)\n", "7:13: error: 'e' stands for itself (expected names that stand above)" },
    { HEAD "exp e = exp(x)\n", "7:5: warning: the exponential 'e' is never used" },
    { HEAD "log l = exp(x)\n", "7:9: error: unexpected 'exp' (expected 'log' after '=')" },
    { HEAD "log l = log(1)\n", "7:9: error: the logarithm of one (expected the number 0)" },
    { HEAD "log l = log(-2)\n", "7:9: error: the logarithm of a number that is not positive" },
    { HEAD "log l = log(x)\nlog k = log(x)\n", "8:9: error: the same logarithm as 'l' (expected one name for it)" },
    { HEAD "log l = log(x)\n", "7:5: warning: the logarithm 'l' is never used" },
    { HEAD "let b = l\nlog l = log(x)\n", "7:9: error: 'l' is used before line 8 defines it (expected names that stand above, so "
                                          "that no circle arises)" },
    { "model t\nstate y\nexp e = exp(y)\nstate x in (0, e)\neq x = x\neq y = y\n",
      "4:12: error: the interval depends on a state (expected numbers and parameters)" },
    { HEAD "let b = pi\nlet pi = a\n", "7:9: error: 'pi' is used before line 8 defines it (expected names that stand above, so "
                                       "that no circle arises)" },
    { HEAD "default a = pi/2\n", "7:13: error: a default in 'pi', which is no rational number (expected one, such as 2/5)" },
    { HEAD "equal e : x = pi when pi = 3\n", "7:23: error: 'pi' cannot be set here (expected a parameter or a state)" },
    { HEAD "let b = Pi\n", "7:9: error: unknown name 'Pi' (expected a name defined above)" },
    { HEAD "default x = 1\n", "7:9: error: 'x' is not a parameter (expected one)" },
    { HEAD "default a = x\n", "7:13: error: a default that is not a number (expected one, such as 2/5)" },
    { HEAD "default a = 1, a = 2\n", "7:16: error: a second default of 'a'" },
    { "model t\nparam a > 0\nstate x\neq x = a\ndefault a = 0\n",
      "5:13: error: the default of 'a' lies outside its own condition" },
    { HEAD "default a = 2\nlet b = 2*a\ndomain near : 3 - b > 0\n",
      "9:8: warning: the defaults lie outside the domain: 3 - b > 0 does not hold" },
    { HEAD "default a = 2\nroot r = sqrt(a^2)\nexp e = exp(a-2)\nlog l = log(a-1)\nangle C S = cos(a-2) sin(a-2)\n"
      "domain near : 1/(r-e-C+S+l) > 0\n", "12:8: warning: the defaults lie outside the domain: 1/(r-e-C+S+l) > 0 does not hold" },
    { "model t\nparam a\nroot r = sqrt(a^2 - 4)\nstate x\neq x = r\ndefault a = 2\n",
      "3:6: warning: the defaults lie outside the domain: what r is the root of is not positive" },
    { "model t\nparam a\nlet b = 1/(a - 2)\nstate x\neq x = b*x\ndefault a = 2\n",
      "5:4: warning: the defaults lie outside the domain: the equation of x divides by zero" },
    { "model t\nparam a\nstate x in (a, 1)\neq x = 1\ndefault a = 1\n",
      "3:7: warning: the defaults lie outside the domain: the interval of x is empty" },

    /* equations */
    { HEAD "eq x = a\n", "7:4: error: a second equation for 'x' (first in line 5)" },
    { HEAD "eq a = x\n", "7:4: error: 'a' is not a state (expected one)" },
    { HEAD "eq z = x\n", "7:4: error: unknown name 'z' (expected a name defined above)" },

    /* variant, time, eliminate */
    { HEAD "variant v : x = 1\n", "7:13: error: 'x' cannot be set here (expected a parameter)" },
    { HEAD "variant v : a = x\n", "7:13: error: the state 'x' stands in a variant (expected parameters and numbers)" },
    { HEAD "variant v : a = a + 1\n", "7:13: error: 'a' is set here and stands in a right-hand side, directly or through "
                                      "definitions: a circle" },
    { HEAD "let b = 2*a\nvariant v : a = b\n", "8:13: error: 'a' is set here and stands in a right-hand side, directly or "
                                               "through definitions: a circle" },
    { HEAD "variant v : a = 1, a = 2\n", "7:20: error: 'a' is set twice" },
    { HEAD "variant v : a = 1\nvariant v : a = 2\n", "8:9: error: a second variant of the name 'v'" },
    { "model t\nparam a > 0\nstate x\neq x = a\nvariant v : a = 0\n",
      "5:13: warning: this value of 'a' lies outside the condition that its record states" },
    { HEAD "time u : -1\n", "7:10: error: the factor of a new time is not positive (expected dt = expr * dtau, expr > 0)" },
    { HEAD "time u : a lifting q\n", "7:20: error: unknown name 'q' (expected a name defined above)" },
    { HEAD "time u : a lifting x\n", "7:20: error: 'x' is not a root (expected one)" },
    { HEAD "integral E = x^2 + y\neliminate c : x by E = L\n",
      "8:11: error: the integral 'E' is not linear in 'x' (expected a state in which it is)" },
    { HEAD "let b = x*y\nintegral E = b*x\neliminate c : x by E = L\n",
      "9:11: error: the integral 'E' is not linear in 'x' (expected a state in which it is)" },
    { HEAD "integral E = y\neliminate c : x by E = L\n",
      "8:11: error: the integral 'E' does not depend on 'x' (expected a state on which it does)" },
    { HEAD "integral E = y when a = 0\neliminate c : y by E = L\n",
      "8:11: error: 'E' is an integral under a condition only (expected one that always holds)" },
    { HEAD "eliminate c : x by E = L\n", "7:20: error: unknown claim 'E' (expected the name of an 'integral' record)" },
    { HEAD "measure M = 1\neliminate c : x by M = L\n",
      "8:20: error: 'M' is the name of 'measure' (expected that of an 'integral' record)" },
    { HEAD "integral E = x\neliminate c : x by E = y\n", "8:24: error: 'y' cannot be a level (expected a new name, or a "
                                                         "parameter)" },
    { HEAD "integral E = x\nintegral F = y\neliminate c : x by E = L\neliminate d : y by F = L\n",
      "10:11: error: 'L' is already the level of 'E'" },

    /* claims */
    { HEAD "integral E = x\nintegral E = y\n", "8:10: error: 'E' is claimed twice (first in line 7)" },
    { HEAD "integral E = x when x^2 = 1\n", "7:22: error: unexpected '^' (expected '=' after the name)" },
    { HEAD "integral E = x when a = 1 when y = 1\n", "7:27: error: a second 'when' (expected one list)" },
    { HEAD "integral E = x modulo E\n", "7:10: error: 'E' rests on itself through 'modulo': a circle" },
    { HEAD "integral E = x modulo F\n",
      "7:23: error: unknown claim 'F' (expected the name of an 'integral' or 'invariant' record)" },
    { HEAD "reversor turn : x -> -x\n", "7:10: error: a reversor has no name (expected 'STATE -> expression')" },
    { HEAD "reversor x = -x\n", "7:12: error: unexpected '=' (expected '->' after the state)" },
    { HEAD "reversor x -> \n", "7:14: error: the table ends within a record (expected a number, a name or '(')" },
    { HEAD "reversor a -> -a\n", "7:10: error: 'a' is not a state (expected one)" },
    { HEAD "reversor x -> -x modulo E\n", "7:18: error: unexpected 'modulo' (expected the end of the record)" },
    { HEAD "reversor x -> -x, x -> -x\n", "7:19: error: 'x' is reversed twice" },
    { HEAD "symmetry x -> -x, x -> y\n", "7:19: error: 'x' is mapped twice" },
    { HEAD "symmetry S x -> -x\n", "7:10: error: unknown name 'S' (expected a name defined above)" },
    { HEAD "integral S = x\nsymmetry S : x -> -x\n", "8:10: error: 'S' is claimed twice (first in line 7)" },
    { HEAD "symmetry S : x -> -x, y -> -y when a = 1 when a = 2\n", "7:42: error: a second 'when' (expected one list)" },
    { HEAD "equilibria f : a = 1\n", "7:16: error: 'a' cannot be set here (expected a state)" },
    { HEAD "equilibria f : x = y, y = 0\n", "7:23: error: 'y' is set here and stands in a right-hand side, directly or through "
                                            "definitions: a circle" },
    { HEAD "equilibria f : x = a when a = x\n", "7:16: error: 'x' is set here and stands in a right-hand side, directly or "
                                                "through definitions: a circle" },
    { HEAD "equilibria f : x = 0 when x = 1\n", "7:27: error: 'x' is set twice" },
    { HEAD "trace f = 0\n", "7:7: error: unknown claim 'f' (expected the name of an 'equilibria' record)" },
    { HEAD "integral E = x\n  trace E = 0\n",
      "8:9: error: 'E' is the name of 'integral' (expected that of an 'equilibria' record)" },
    { HEAD "equilibria f : x = 0\n  trace f = 0\n  trace f = 1\n", "9:9: error: 'f' is claimed twice (first in line 8)" },
    { HEAD "equilibria f : x = 0\n  trace f = 0 when a = 1\n",
      "8:15: error: 'when' is a keyword and names nothing (expected the end of the record)" },
    { HEAD "equilibria f : x = 0\n  matrix f = 1, 2; 3\n", "8:20: error: a row of 1 entries (expected 2, as in the first row)" },
    { HEAD "equilibria f : x = 0\n  matrix f = 1, 2\n", "8:10: error: a matrix of 2 entries (expected 2 rows of 2)" },
    { HEAD "equilibria f : x = 0\n  leftnull f : f\n",
      "8:16: error: 'f' is the name of 'equilibria' (expected that of an 'integral' record)" },
    { HEAD "equal e : x\n", "7:12: error: the table ends within a record (expected '=' after the left side)" },
    { HEAD "reduction r : onto ../t.tt with x = x\n", "7:20: error: not the name of a table (expected FILE.tt, beside this one)" },
    { HEAD "reduction r : onto\nparam b\n", "7:19: error: the record ends too early (expected FILE.tt, beside this one)" },
    { HEAD "reduction r : onto t.txt with x = x\n", "7:20: error: not the name of a table (expected FILE.tt, beside this one)" },
    { HEAD "reduction r : onto t.tt with x = x, x = y\n", "7:37: error: 'x' is set twice" },
};

/* What was said about a text, first line only. */
static void first_line(const char *text, size_t length, char *line, size_t size)
{
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    assert_non_null(diagnostics);
    ttc_model *model = ttc_model_parse(text, length, "t", diagnostics);
    assert_true((model == NULL) == (ttc_error_count(diagnostics) > 0));
    ttc_model_destroy(model);
    snprintf(line, size, "nothing");
    if (ttc_diagnostics_size(diagnostics) > 0) {
        ttc_diagnostic d = ttc_diagnostics_at(diagnostics, 0);
        snprintf(line, size, "%u:%u: %s: %s%s", (unsigned)d.line, (unsigned)d.column,
                 d.severity == TTC_ERROR ? "error" : "warning", d.message,
                 ttc_error_count(diagnostics) + ttc_warning_count(diagnostics) > 1 ? " AND MORE" : "");
    }
    ttc_diagnostics_destroy(diagnostics);
}

static void each_mistake_is_told_once_and_in_place(void **unused)
{
    (void)unused;
    size_t wrong = 0;
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; i++) {
        char line[600];
        first_line(mistakes[i].text, strlen(mistakes[i].text), line, sizeof line);
        if (strcmp(line, mistakes[i].expected) == 0) continue;
        print_error("table:\n%s\nexpected %s\nbut said %s\n", mistakes[i].text, mistakes[i].expected, line);
        wrong++;
    }
    assert_int_equal(wrong, 0);
}

static void a_nul_byte_is_an_error(void **unused)
{
    (void)unused;
    const char text[] = HEAD "# a\0b\n";
    char line[600];
    first_line(text, sizeof text - 1, line, sizeof line);
    assert_string_equal(line, "7:4: error: a NUL byte (expected UTF-8 text)");
}

static char *repeat(const char *before, const char *unit, size_t count, const char *after)
{
    size_t length = strlen(unit);
    char *text = malloc(strlen(before) + count * length + strlen(after) + 1);
    assert_non_null(text);
    strcpy(text, before);
    char *at = text + strlen(before);
    for (size_t i = 0; i < count; i++, at += length) memcpy(at, unit, length);
    strcpy(at, after);
    return text;
}

static void says(char *text, const char *expected)
{
    char line[600];
    first_line(text, strlen(text), line, sizeof line);
    free(text);
    assert_string_equal(line, expected);
}

static void size_is_bounded_in_every_direction(void **unused)
{
    (void)unused;
    says(repeat(HEAD, "#\n", TTC_SOURCE_LIMIT / 2, ""), "1:1: error: the table is too large (expected at most 1048576 bytes)");
    says(repeat(HEAD "let b = ", "(", 257, "a"), "7:265: error: parentheses nest too deep (expected at most 256)");
    says(repeat(HEAD "let b = 1", "0", 1000, ""), "7:9: error: a number of 1001 characters (expected at most 1000)");

    /* b_n written out has 7*2^n - 3 operands: b_18 in line 25 is the first beyond a million */
    char *text = repeat(HEAD, "                          ", 30, "");
    char *at = text + strlen(HEAD);
    at += sprintf(at, "let b0 = a + x + y\n");
    for (int i = 1; i <= 20; i++) at += sprintf(at, "let b%d = b%d*(1 + b%d^2)\n", i, i - 1, i - 1);
    char line[600];
    first_line(text, strlen(text), line, sizeof line);
    free(text);
    assert_string_equal(line, "25:11: error: the expression written out in full is too large (expected at most 1000000 "
                              "operands)");
}

static void recovery_finds_every_mistake_of_a_table_in_order(void **unused)
{
    (void)unused;
    /* the last is seen first, by the lexer */
    static const char text[] = "model t\nparam a >\nstate x in [0]\nlet b = q +\n  1\nlet c = 1/0\neq x = 2x\n";
    static const unsigned lines[] = { 2, 3, 4, 6, 7 };
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    assert_null(ttc_model_parse(text, strlen(text), "t", diagnostics));
    assert_int_equal(ttc_error_count(diagnostics), 5);
    for (size_t i = 0; i < 5; i++) assert_int_equal(ttc_diagnostics_at(diagnostics, i).line, lines[i]);
    ttc_diagnostics_destroy(diagnostics);
}

static void printed(const char *text, const char *expected)
{
    char *buffer = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&buffer, &size);
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    assert_non_null(stream);
    ttc_model_destroy(ttc_model_parse(text, strlen(text), "dir/t.tt", diagnostics));
    ttc_diagnostics_print(diagnostics, stream);
    fclose(stream);
    assert_string_equal(buffer, expected);
    free(buffer);
    ttc_diagnostics_destroy(diagnostics);
}

static void the_caret_stands_under_the_mistake(void **unused)
{
    (void)unused;
    printed(HEAD "\tlet b = q\n", "dir/t.tt:7:10: error: unknown name 'q' (expected a name defined above)\n"
                                  "     let b = q\n"
                                  "             ^\n");
    printed(HEAD "title \"\xc3\xa9\xc3\xa9\" q\n", "dir/t.tt:7:14: error: unexpected 'q' (expected the end of the record)\n"
                                                   "    title \"\xc3\xa9\xc3\xa9\" q\n"
                                                   "               ^\n");
    printed(HEAD "let b = a \x01\n", "dir/t.tt:7:11: error: a control character (expected printable text)\n"
                                     "    let b = a ?\n"
                                     "              ^\n");
}

static void reports_beyond_the_limit_are_counted(void **unused)
{
    (void)unused;
    char *text = repeat(HEAD, "let b = q\n", 80, "");
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    assert_null(ttc_model_parse(text, strlen(text), "t", diagnostics));
    assert_true(ttc_error_count(diagnostics) >= 80);
    assert_int_equal(ttc_diagnostics_size(diagnostics), TTC_DIAGNOSTIC_LIMIT);
    ttc_diagnostics_destroy(diagnostics);
    free(text);
}

static void a_file_that_cannot_be_read_is_not_a_bad_table(void **unused)
{
    (void)unused;
    ttc_diagnostics *diagnostics = ttc_diagnostics_create();
    assert_null(ttc_model_read("/nonexistent/table.tt", diagnostics));
    assert_int_equal(ttc_io_error_count(diagnostics), 1);
    assert_int_equal(ttc_error_count(diagnostics), 1);
    ttc_diagnostics_destroy(diagnostics);
    ttc_diagnostics_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_mistake_is_told_once_and_in_place),
        cmocka_unit_test(a_nul_byte_is_an_error),
        cmocka_unit_test(size_is_bounded_in_every_direction),
        cmocka_unit_test(recovery_finds_every_mistake_of_a_table_in_order),
        cmocka_unit_test(the_caret_stands_under_the_mistake),
        cmocka_unit_test(reports_beyond_the_limit_are_counted),
        cmocka_unit_test(a_file_that_cannot_be_read_is_not_a_bad_table),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
