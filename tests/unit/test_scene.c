/* Scene files: what they become, and that every mistake is named with its line. */
#include "unit/check.h"

#include <stdlib.h>
#include <unistd.h>

#include "cli/job.h"
#include "scene/schema.h"

static jlt_status read_text(jlt_scene **scene, char *message, const char *text)
{
    char path[] = "/tmp/jellett_scene_XXXXXX";
    const int descriptor = mkstemp(path);
    jlt_status st;

    assert_true(descriptor >= 0);
    assert_int_equal(write(descriptor, text, strlen(text)), (ssize_t)strlen(text));
    close(descriptor);
    st = jlt_scene_read(scene, message, path, &jlt_job_program);
    unlink(path);
    /* the path in front is random: drop it */
    if (strncmp(message, path, strlen(path)) == 0) memmove(message, message + strlen(path), strlen(message + strlen(path)) + 1);
    return st;
}

static void a_scene_becomes_options_of_commands_with_exact_numbers(void **unused)
{
    char message[JLT_SCENE_MESSAGE_MAX];
    jlt_scene *scene = NULL;

    (void)unused;
    assert_int_equal(read_text(&scene, message,
                               "title = \"two\"; model = \"spherical_top\";\n"
                               "parameters = { m = 1; a3 = 0.51; I1 = \"1/3\"; };\n"
                               "levels = { E = 2.15; G = -0.56; };\n"
                               "accuracy = { tolerance = 1e-13; tier = \"five\"; };\n"
                               "compute = (\n"
                               "  { what = \"simulate\"; start = { gamma3 = 0.1; }; times = ( 0, \"1/3\", 2 ); track = true; },\n"
                               "  { what = \"section\"; grid = { eta = (\"-pi\", 3, 8); gamma3 = 0.5; }; returns = 10; },\n"
                               "  { what = \"fates\"; grid = \"24x16\"; } );\n"),
                     JLT_OK);
    assert_string_equal(scene->title, "two");
    assert_int_equal(scene->count, 3);
    assert_string_equal(scene->jobs[0].what, "simulate");
    assert_string_equal(scene->jobs[0].model, "spherical_top");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "set"), "m=1,a3=0.51,I1=1/3");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "times"), "0,1/3,2");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "start"), "gamma3=0.1");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "tol"), "1e-13");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "tier"), "five");
    assert_null(jlt_scene_value(&scene->jobs[0], "level")); /* simulate knows no levels */
    assert_null(jlt_scene_value(&scene->jobs[1], "tier"));
    assert_string_equal(jlt_scene_value(&scene->jobs[1], "level"), "E=2.15,G=-0.56");
    assert_string_equal(jlt_scene_value(&scene->jobs[1], "grid"), "eta=-pi:3:8,gamma3=0.5");
    assert_string_equal(jlt_scene_value(&scene->jobs[2], "grid"), "24x16");
    jlt_scene_destroy(scene);
}

static void an_entry_takes_what_its_command_takes(void **unused)
{
    char message[JLT_SCENE_MESSAGE_MAX];
    jlt_scene *scene = NULL;

    (void)unused;
    assert_int_equal(read_text(&scene, message,
                               "accuracy = { tier = \"five\"; };\n"
                               "compute = ( { what = \"drift\"; returns = 7; tolerance = 1e-9; parameters = { a3 = 0.5; }; },\n"
                               "            { what = \"orbits\"; hold = \"eta\"; line = { gamma3 = (0, \"pi/2\", 9); }; settle = "
                               "0; },\n"
                               "            { what = \"continue\"; along = { E = (1, 2); }; generations = 2; } );\n"),
                     JLT_OK);
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "returns"), "7");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "tol"), "1e-09");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "set"), "a3=0.5");
    assert_null(jlt_scene_value(&scene->jobs[0], "tier")); /* drift follows no tier */
    assert_string_equal(jlt_scene_value(&scene->jobs[1], "hold"), "eta");
    assert_string_equal(jlt_scene_value(&scene->jobs[1], "line"), "gamma3=0:pi/2:9");
    assert_string_equal(jlt_scene_value(&scene->jobs[1], "settle"), "0");
    assert_string_equal(jlt_scene_value(&scene->jobs[2], "along"), "E=1:2");
    assert_string_equal(jlt_scene_value(&scene->jobs[2], "generations"), "2");
    jlt_scene_destroy(scene);
}

/* An argument of a form that no kind of value has would be taken for any text. */
static void every_option_takes_a_kind_of_value_that_scenes_know(void **unused)
{
    const struct argp *options = NULL;
    const char *command;

    (void)unused;
    for (size_t i = 0; (command = jlt_job_program.command(&options, i)) != NULL; i++) {
        char names[1024] = "";
        jlt_key key;
        jlt_schema_key_names(names, sizeof names, options);
        for (char *name = strtok(names, ", "); name != NULL; name = strtok(NULL, ", ")) {
            assert_true(jlt_schema_key(&key, options, name));
            const size_t lower = key.words != NULL ? strspn(key.words, "abcdefghijklmnopqrstuvwxyz|") : 0;
            if (key.words != NULL && strstr(key.words, "=VALUE") == NULL && key.words[lower] != '\0')
                fail_msg("%s --%s=%s: no kind of value of scene/schema.c", command, key.option, key.words);
        }
    }
}

static void every_mistake_is_named_with_its_line(void **unused)
{
    static const struct {
        const char *text, *message;
    } cases[] = {
        { "compute = ( { what = \"section\"; }\n", ":2: error: syntax error" },
        { "compute = ();", ":1: error: 'compute' is empty" },
        { "title = \"x\";", ": error: nothing to do: no 'compute'" },
        { "compute = { what = \"section\"; };", ":1: error: 'compute' takes a list in parentheses" },
        { "paramters = { m = 1; };\ncompute = ( { what = \"section\"; } );", ":1: error: unknown key 'paramters'" },
        { "compute = (\n { what = \"sections\"; } );", ":2: error: unknown command \"sections\" (expected one of verify" },
        { "compute = ( { returns = 3; } );", ":1: error: an entry of 'compute' needs what" },
        { "compute = ( { what = \"section\";\n retruns = 3; } );", ":2: error: unknown key 'retruns' for section (it knows what" },
        { "compute = ( { what = \"section\";\n returns = 0; } );", ":2: error: 'returns' must be at least 1" },
        { "compute = ( { what = \"section\";\n returns = 1.5; } );", ":2: error: 'returns' takes a whole number" },
        { "compute = ( { what = \"simulate\";\n\n times = 3; } );", ":3: error: 'times' takes numbers in parentheses" },
        { "compute = ( { what = \"simulate\"; until = \"1/0\"; } );", ":1: error: 'until' is no number: \"1/0\"" },
        { "compute = ( { what = \"simulate\"; track = 1; } );", ":1: error: 'track' takes true or false" },
        { "parameters = { m = \"nan\"; };\ncompute = ( { what = \"section\"; } );", ":1: error: 'm' is no number: \"nan\"" },
        { "parameters = { m = \"1e999\"; };\ncompute = ( { what = \"section\"; } );", ":1: error: 'm' is beyond the range" },
        { "parameters = {\n m = 1e-400; };\ncompute = ( { what = \"section\"; } );", ":2: error: 1e-400 is no number in" },
        { "parameters = { m = -.5e309; };\ncompute = ( { what = \"section\"; } );", ":1: error: .5e309 is no number in the" },
        { "parameters = { m = 1e99999; };\ncompute = ( { what = \"section\"; } );", ":1: error: 1e99999 is no number in the" },
        { "accuracy = { tolerence = 1e-3; };\ncompute = ( { what = \"section\"; } );",
          ":1: error: unknown key 'tolerence' in 'accuracy'" },
        { "compute = ( { what = \"section\";\n grid = { eta = (1, 2); }; } );", ":2: error: 'eta' takes one number or (first" },
        { "compute = ( { what = \"section\";\n grid = { eta = (1, 2, 0); }; } );", ":2: error: 'how many of eta' must be at le" },
        { "compute = ( { what = \"section\";\n grid = { eta = (1, 2, 2.5); }; } );", ":2: error: 'how many of eta' takes a whole" },
        { "compute = ( { what = \"section\";\n grid = 5; } );",
          ":2: error: 'grid' takes names and numbers in braces, { a = (-1, 1, 21)" },
        { "compute = ( { what = \"section\";\n section = { v_nu = 0; };\n start = \"saddle\"; } );",
          ":3: error: 'start' takes names and numbers in braces" },
        { "title = 3;\ncompute = ( { what = \"section\"; } );", ":1: error: 'title' takes a text" },
        { "model = \"top\";\ncompute = ( { what = \"simulate\"; } );", ":1: error: there is no model 'top' (" },
        { "parameters = { m = 1;\n mu = 2; };\ncompute = ( { what = \"section\"; } );",
          ":2: error: 'parameters' does not know 'mu' (it knows m, R, g, a3, I1, I3)" },
        { "levels = { F0 = 1; };\ncompute = ( { what = \"section\"; } );",
          ":1: error: 'levels' does not know 'F0' (it knows E, G)" },
        { "levels = { F = 1; };\ncompute = ( { what = \"section\"; section = { omega_tau = 0; }; solve = { v_nu = 1; }; } );",
          ":1: error: 'levels' does not know 'F' (it knows E, G, F0" },
        { "compute = ( { what = \"section\"; levels = { F0 = 1; }; } );",
          ":1: error: 'levels' does not know 'F0' (it knows E, G)" },
        { "levels = { E1 = 1; };\ncompute = ( { what = \"portrait\"; } );",
          ":1: error: 'levels' does not know 'E1' (it knows E, G, F0)" },
        { "compute = ( { what = \"section\"; section = { omega_tau = 0; gamma3 = 0; }; } );",
          ":1: error: 'section' takes one state" },
        { "compute = ( { what = \"section\"; section = { }; } );", ":1: error: 'section' takes one state" },
        { "compute = ( { what = \"section\"; section = { omega_tau = 0; }; start = { omega_tau = 0; }; } );",
          ":1: error: 'start' does not know 'omega_tau' (it knows gamma3, v_nu, omega_n, omega3)" },
        { "compute = ( { what = \"section\"; section = { omega_tau = 0; }; modulo = { gamma3 = \"2*pi/x\"; }; } );",
          ":1: error: 'gamma3' is no number: \"2*pi/x\"" },
        { "model = \"roessler\";\ncompute = ( { what = \"section\"; section = { y = 0; }; levels = { E = 1; }; } );",
          ":2: error: 'levels' does not know 'E' (it knows none)" },
        { "compute = ( { what = \"section\"; start = { omega_n = 1; }; } );",
          ":1: error: 'start' does not know 'omega_n' (it knows eta, gamma3)" },
        { "compute = ( { what = \"section\"; section = { omega_tau = 0; }; start = { eta = 1; }; } );",
          ":1: error: 'start' does not know 'eta' (it knows gamma3, v_nu" },
        { "compute = ( { what = \"fates\"; sweep = { M = 1; }; } );",
          ":1: error: 'sweep' does not know 'M' (it knows m, R, g, a3, I1, I3, E, G)" },
        { "compute = ( { what = \"simulate\"; start = { gamma = 1; }; } );",
          ":1: error: 'start' does not know 'gamma' (it knows gamma3, v_nu" },
        { "compute = ( { what = \"section\"; tolerance = 1; tol = 1; } );", ":1: error: unknown key 'tol' for section" },
        { "accuracy = { method = \"gauss\"; };\ncompute = ( { what = \"section\"; method = \"gauss\"; } );",
          ":2: error: 'method' is already given for the whole scene" },
        { "compute = ( { what = \"rod\"; sweep = { E = 1; }; } );", ":1: error: 'sweep' does not know 'E' (it knows gamma3, v_nu" },
        { "compute = ( { what = \"section\"; direction = \"left\"; } );",
          ":1: error: 'direction' does not know 'left' (it knows up, down, both)" },
        { "accuracy = { method = \"euler\"; };\ncompute = ( { what = \"section\"; } );",
          ":1: error: 'method' does not know 'euler' (it knows gauss, dop853" },
        { "parameters = { a3 = 3000000000; };\ncompute = ( { what = \"section\"; } );",
          ":1: error: the whole number 3000000000 is too large" },
        { "compute = ( { what = \"section\"; returns = 0x80000000; } );", ":1: error: 0x80000000: numbers are decimal" },
        { "parameters = { a3 = -010; };\ncompute = ( { what = \"section\"; } );", ":1: error: 010: numbers are decimal" },
        { "parameters = { a3 = 0.0; R = 00; };\ncompute = ( { what = \"section\"; } );", ":1: error: 00: numbers are decimal" },
        { "parameters = { a3 = 0.;\nm = .; };\ncompute = ( { what = \"section\"; } );", ":2: error: . is no number" },
        { "parameters = { a3 = .e5; };\ncompute = ( { what = \"section\"; } );", ":1: error: .e5 is no number" },
        { "parameters.a3 = 1;\ncompute = ( { what = \"section\"; } );", ":1: error: syntax error (expected NAME = VALUE" },
        { "levels.eta = 1;\ncompute = ( { what = \"section\"; } );", ":1: error: syntax error (expected NAME = VALUE" },
        { "# 99999999999\n/* 99999999999\n*/ title = \"99999999999 \\\" 99999999999\"; // 99999999999\n"
          "parameters = { a3 = 99999999999999999999L; };\ncompute = ( { what = \"section\"; } );",
          ":4: error: the whole number 99999999999999999999L is too large" },
        { "title = \"@include\";\n@include \"x\"\n", ":2: error: @include" },
        { "title = \"a\";\ntitle = \"b\";\n", ":2: error: duplicate setting name" },
    };

    (void)unused;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char message[JLT_SCENE_MESSAGE_MAX];
        jlt_scene *scene = NULL;
        assert_int_equal(read_text(&scene, message, cases[i].text), JLT_ERR_ARG);
        assert_null(scene);
        if (strncmp(message, cases[i].message, strlen(cases[i].message)) != 0)
            fail_msg("expected '%s...', got '%s'", cases[i].message, message);
    }
}

static void numbers_and_methods_are_those_of_the_commands(void **unused)
{
    char message[JLT_SCENE_MESSAGE_MAX];
    jlt_scene *scene = NULL;

    (void)unused;
    assert_int_equal(read_text(&scene, message,
                               "parameters = { m = 3000000000L; R = 1e-300; g = 99999999999.5; I1 = 2147483647; };\n"
                               "accuracy = { method = \"gauss\"; };\n"
                               "compute = ( { what = \"section\"; returns = 9223372036854775807L; } );\n"),
                     JLT_OK);
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "set"), "m=3000000000,R=1e-300,g=99999999999.5,I1=2147483647");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "method"), "gauss");
    assert_string_equal(jlt_scene_value(&scene->jobs[0], "returns"), "9223372036854775807");
    jlt_scene_destroy(scene);
}

static void a_file_that_cannot_be_read_is_no_bad_scene(void **unused)
{
    char message[JLT_SCENE_MESSAGE_MAX];
    jlt_scene *scene = NULL;

    (void)unused;
    assert_int_equal(jlt_scene_read(&scene, message, "/tmp", &jlt_job_program), JLT_ERR_IO);
    assert_null(scene);
    assert_string_equal(message, "/tmp: error: Is a directory");
    assert_int_equal(jlt_scene_read(&scene, message, "/dev/zero", &jlt_job_program), JLT_ERR_ARG); /* without an end */
    assert_null(scene);
}

static void a_missing_file_is_an_input_error_of_its_own(void **unused)
{
    char message[JLT_SCENE_MESSAGE_MAX];
    jlt_scene *scene = NULL;

    (void)unused;
    assert_int_equal(jlt_scene_read(&scene, message, "/nonexistent/x.scene", &jlt_job_program), JLT_ERR_IO);
    assert_null(scene);
    assert_string_equal(message, "/nonexistent/x.scene: error: No such file or directory");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_scene_becomes_options_of_commands_with_exact_numbers),
        cmocka_unit_test(an_entry_takes_what_its_command_takes),
        cmocka_unit_test(every_option_takes_a_kind_of_value_that_scenes_know),
        cmocka_unit_test(every_mistake_is_named_with_its_line),
        cmocka_unit_test(numbers_and_methods_are_those_of_the_commands),
        cmocka_unit_test(a_file_that_cannot_be_read_is_no_bad_scene),
        cmocka_unit_test(a_missing_file_is_an_input_error_of_its_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
