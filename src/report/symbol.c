#include "report/symbol.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name, *letter;
} greek[] = {
    { "alpha", "α" }, { "beta", "β" },   { "gamma", "γ" },   { "delta", "δ" }, { "epsilon", "ε" }, { "zeta", "ζ" },
    { "eta", "η" },   { "theta", "θ" },  { "iota", "ι" },    { "kappa", "κ" }, { "lambda", "λ" },  { "mu", "μ" },
    { "nu", "ν" },    { "xi", "ξ" },     { "pi", "π" },      { "rho", "ρ" },   { "sigma", "σ" },   { "tau", "τ" },
    { "upsilon", "υ" }, { "phi", "φ" },  { "chi", "χ" },     { "psi", "ψ" },   { "omega", "ω" },   { "Gamma", "Γ" },
    { "Delta", "Δ" }, { "Theta", "Θ" },  { "Lambda", "Λ" },  { "Xi", "Ξ" },    { "Pi", "Π" },      { "Sigma", "Σ" },
    { "Phi", "Φ" },   { "Psi", "Ψ" },    { "Omega", "Ω" },
};

void jlt_symbol_plain(FILE *stream, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        if (strchr("{}^_@&~\\", text[i]) != NULL) fputc('\\', stream);
        fputc(text[i], stream);
    }
}

void jlt_symbol_unit(FILE *stream, const char *unit)
{
    for (size_t length = strcspn(unit, "^"); *unit != '\0'; length = strcspn(unit, "^")) {
        jlt_symbol_plain(stream, unit, length);
        unit += length;
        if (*unit == '\0') return;
        const bool below = unit[1] == '-';
        const size_t digits = strspn(unit + 1 + below, "0123456789");
        fprintf(stream, "^{%s%.*s}", below ? "−" : "", (int)digits, unit + 1 + below);
        unit += 1 + below + digits;
    }
}

/* Write the first `length` characters of a name, as a Greek letter if they name one. Returns whether one letter was written. */
static bool write_part(FILE *stream, const char *name, size_t length)
{
    for (size_t i = 0; i < sizeof greek / sizeof *greek; i++)
        if (strlen(greek[i].name) == length && strncmp(name, greek[i].name, length) == 0) {
            fputs(greek[i].letter, stream);
            return true;
        }
    jlt_symbol_plain(stream, name, length);
    return length == 1;
}

/* How many characters of a part of a name stand before the digits at its end. */
static size_t without_digits(const char *name, size_t length)
{
    while (length > 0 && isdigit((unsigned char)name[length - 1])) length--;
    return length;
}

void jlt_symbol_write(FILE *stream, const char *name)
{
    const size_t stem = strcspn(name, "_"), letters = without_digits(name, stem);
    const bool is_letter = write_part(stream, name, letters);
    const char *part = name + stem + strspn(name + stem, "_"), *separator = is_letter && letters < stem ? "," : "";

    if (!is_letter) fwrite(name + letters, 1, stem - letters, stream);
    if (*part == '\0' && *separator == '\0') return;
    fputs("_{", stream);
    if (is_letter) fwrite(name + letters, 1, stem - letters, stream);
    for (size_t length; *part != '\0'; part += length + strspn(part + length, "_")) {
        length = strcspn(part, "_");
        const size_t before = without_digits(part, length);
        fputs(separator, stream);
        (void)write_part(stream, part, before);
        fwrite(part + before, 1, length - before, stream);
        separator = ",";
    }
    fputc('}', stream);
}

void jlt_symbol_number(FILE *stream, double value)
{
    char text[32];
    const char *digits = text;

    (void)snprintf(text, sizeof text, "%.6g", value);
    if (*digits == '-') fputs("−", stream), digits++;
    const size_t length = strcspn(digits, "e");
    const int power = digits[length] == 'e' ? atoi(digits + length + 1) : 0;
    const bool is_power = power != 0 && length == 1 && *digits == '1';
    if (!is_power) fwrite(digits, 1, length, stream);
    if (power != 0) fprintf(stream, "%s10^{%s%d}", is_power ? "" : "×", power < 0 ? "−" : "", abs(power));
}
