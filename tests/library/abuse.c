/* The library as a careless caller has it: NULL everywhere, freeing twice, numbers that are none, bad
 * decks, little room. Prints TAP.
 *     abuse ROOT
 */
#include <loft.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int checks, failures;

static void ok(int passed, const char *name)
{
    checks++;
    if (!passed) failures++;
    printf("%sok %d - %s\n", passed ? "" : "not ", checks, name);
}

/* True where a call failed for a reason; frees the error. */
static int failed_for(int cause, const char *word, loft_error **error)
{
    char message[300];
    int is_so = *error != NULL && loft_error_cause(*error) == cause;
    loft_error_message(*error, message, sizeof message);
    if (word) is_so = is_so && strstr(message, word) != NULL;
    if (!is_so) printf("# cause %d: %s\n", loft_error_cause(*error), message);
    loft_error_free(error);
    return is_so && *error == NULL;
}

static void null_handles(void)
{
    loft_deck *deck = NULL;
    loft_cut *cut = NULL;
    loft_table *table = NULL;
    loft_error *error = NULL;
    loft_fault fault;
    loft_point point;
    loft_row row;
    loft_measure measure;
    loft_section section;
    loft_duct duct;
    loft_duct_section round;
    char room[8] = "filled";
    double origin[3] = {0, 0, 0};

    loft_deck_free(NULL); loft_cut_free(NULL); loft_table_free(NULL); loft_error_free(NULL);
    loft_deck_free(&deck); loft_cut_free(&cut); loft_table_free(&table); loft_error_free(&error);
    ok(loft_deck_kind(NULL) == LOFT_NO_DECK && loft_deck_body_count(NULL) == 0
        && loft_deck_section_count(NULL, 1) == 0 && loft_deck_duct_count(NULL, 1) == 0 && loft_deck_cut_count(NULL) == 0
        && loft_deck_card_count(NULL) == 0 && loft_deck_fault_count(NULL) == 0
        && loft_deck_error_count(NULL) == 0 && loft_cut_point_count(NULL) == 0
        && loft_cut_outline_count(NULL) == 0 && loft_cut_note_count(NULL) == 0
        && loft_cut_kind(NULL) == 0 && loft_cut_outline_is_closed(NULL, 1) == 0
        && loft_table_row_count(NULL) == 0 && loft_error_cause(NULL) == LOFT_NO_ERROR,
        "a NULL handle has nothing");
    ok(loft_deck_title(NULL, room, sizeof room) == 0 && room[0] == '\0', "and an empty title");
    ok(loft_deck_units(NULL, NULL, 0) == 0 && loft_deck_body_name(NULL, 1, NULL, 0) == 0
        && loft_deck_section_name(NULL, 1, 1, NULL, 0) == 0 && loft_deck_duct_name(NULL, 1, 1, NULL, 0) == 0
        && loft_deck_cut_name(NULL, 1, NULL, 0) == 0
        && loft_deck_card_label(NULL, 1, NULL, 0) == 0 && loft_deck_fault_message(NULL, 1, NULL, 0) == 0
        && loft_deck_fault_card(NULL, 1, NULL, 0) == 0 && loft_cut_name(NULL, NULL, 0) == 0
        && loft_cut_section_name(NULL, 1, NULL, 0) == 0 && loft_cut_note(NULL, 1, NULL, 0) == 0
        && loft_error_message(NULL, NULL, 0) == 0, "and no other words");
    ok(loft_deck_fault(NULL, 1, &fault) == 0 && loft_cut_points(NULL, 1, 1, &point) == 0
        && loft_table_rows(NULL, 1, 1, &row) == 0, "and gives nothing out");
    ok(!loft_deck_load(NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "path is NULL", &error),
        "a NULL path is an error");
    ok(!loft_deck_parse(NULL, 10, &error) && failed_for(LOFT_BAD_ARGUMENT, "text is NULL", &error),
        "a NULL text is an error");
    ok(!loft_deck_cut(NULL, 1, &error) && failed_for(LOFT_BAD_ARGUMENT, "deck is NULL", &error),
        "a cut of a NULL deck is an error");
    ok(!loft_cut_station(NULL, 1, 0, NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_cut_buttock(NULL, 1, 0, NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_cut_waterline(NULL, 1, 0, NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_cut_plane(NULL, 1, origin, origin, NULL, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error), "of any kind");
    ok(!loft_deck_measure(NULL, 1, &measure, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_deck_measure_station(NULL, 1, 0, &section, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_deck_measure_duct(NULL, 1, 1, &duct, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "deck is NULL", &error)
        && !loft_deck_measure_duct_station(NULL, 1, 1, 0, &round, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "deck is NULL", &error)
        && !loft_deck_table(NULL, 1, LOFT_X, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error),
        "and so are its measures and tables");
    ok(!loft_deck_load("/no/such/deck", NULL), "nobody need ask why");
}

static void files(const char *root)
{
    loft_error *error = NULL;
    loft_deck *deck;
    FILE *file;
    char path[600];

    ok(!loft_deck_load("/no/such/deck", &error)
        && failed_for(LOFT_FILE_TROUBLE, "/no/such/deck: No such file", &error),
        "a deck that is not there: the system's words");
    ok(!loft_deck_load("/tmp", &error) && failed_for(LOFT_FILE_TROUBLE, "Is a directory", &error),
        "a folder is no deck");
    ok(!loft_deck_load("", &error) && failed_for(LOFT_FILE_TROUBLE, NULL, &error), "nor is no name");
    ok(!loft_deck_load("-", &error) && failed_for(LOFT_FILE_TROUBLE, NULL, &error),
        "- is a file of that name, not standard input");
    snprintf(path, sizeof path, "%s/d\xc3\xa9""ck n\xc2\xb0 1 $(x)'.crd", root);
    file = fopen(path, "w");
    ok(file != NULL, "a path in UTF-8 with blanks and quotes is made");
    if (!file) return;
    fputs("TITLE   R\xc3\xa9sum\xc3\xa9\n-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   40."
          "\n999.999\n", file);
    fclose(file);
    deck = loft_deck_load(path, &error);
    ok(deck != NULL && error == NULL, "and loaded");
    ok(loft_deck_kind(deck) == LOFT_DECK_1970 && loft_deck_card_count(deck) == 1
        && loft_deck_fault_count(deck) == 0, "it is a deck of one conic card");
    loft_deck_free(&deck);
    ok(deck == NULL, "freeing a handle makes it NULL");
    loft_deck_free(&deck);
    remove(path);
}

static void little_room(void)
{
    static const char text[] = "TITLE   R\xc3\xa9sum\xc3\xa9\nUNITS   MM\n0.,0.,0.,1.,.4,2.,2.,2.,1.\n999.999\n";
    loft_error *error = NULL;
    loft_deck *deck = loft_deck_parse(text, sizeof text - 1, &error);
    char room[16];

    memset(room, 'x', sizeof room);
    ok(deck && loft_deck_title(deck, room, 16) == 8 && !strcmp(room, "R\xc3\xa9sum\xc3\xa9"),
        "a title is copied whole");
    memset(room, 'x', sizeof room);
    ok(loft_deck_title(deck, room, 3) == 8 && !strcmp(room, "R") && room[3] == 'x',
        "with little room no letter is cut in two, nothing behind it is touched");
    ok(loft_deck_title(deck, room, 4) == 8 && !strcmp(room, "R\xc3\xa9"), "with room for it it is there");
    ok(loft_deck_title(deck, room, 1) == 8 && room[0] == '\0', "room for the null alone");
    memset(room, 'x', sizeof room);
    ok(loft_deck_title(deck, room, 0) == 8 && room[0] == 'x', "no room, nothing written");
    ok(loft_deck_units(deck, room, sizeof room) == 2 && !strcmp(room, "MM"), "units are copied");
    loft_deck_free(&deck);
}

static void bad_decks(const char *root)
{
    static const char card[] =
        "-30.    -10.    .114    0.      -7.1    50.     -4.     .0523   5.\n"
        "-30.    -10.    .1x4    0.      -7.1    50.     -4.     .0523   5.\n999.999\n";
    loft_error *error = NULL;
    loft_deck *deck;
    loft_fault fault;
    loft_table *table;
    char room[200];

    (void)root;
    deck = loft_deck_parse(card, sizeof card - 1, &error);
    ok(deck && !error && loft_deck_error_count(deck) == 1, "a card in error is no error of loading");
    ok(loft_deck_fault(deck, 1, &fault) && fault.line == 2 && fault.first == 19 && fault.last == 19
        && fault.severity == LOFT_ERROR, "its fault has line, columns and severity");
    ok(loft_deck_fault_message(deck, 1, room, sizeof room) > 10 && strstr(room, "S1") != NULL,
        "its message names the field");
    ok(loft_deck_fault_card(deck, 1, room, sizeof room) == 66 && !strncmp(room, "-30.    -10.    .1x4", 20),
        "its card is shown");
    ok(!loft_deck_fault(deck, 0, &fault) && !loft_deck_fault(deck, 2, &fault)
        && loft_deck_fault_message(deck, 2, room, sizeof room) == 0, "there is no fault 0 or 2");
    table = loft_deck_table(deck, 1, LOFT_X, &error);
    ok(table && loft_table_row_count(table) == 17, "the sound card has its table");
    loft_table_free(&table);
    table = loft_deck_table(deck, 2, LOFT_X, &error);
    ok(table && !error && loft_table_row_count(table) == 0, "the other has no rows");
    loft_table_free(&table);
    ok(!loft_deck_table(deck, 3, LOFT_X, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no conic card 3; it has 2", &error), "there is no third card");
    ok(!loft_deck_cut(deck, 1, &error) && failed_for(LOFT_BAD_ARGUMENT, "no cut 1", &error),
        "a 1970 deck has no cut");
    ok(!loft_cut_station(deck, 1, 0., NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "no body 1", &error),
        "and no body");
    loft_deck_free(&deck);
    deck = loft_deck_parse("", 0, &error);
    ok(deck && loft_deck_error_count(deck) == 1, "an empty deck is in error, and is one");
    loft_deck_free(&deck);
    deck = loft_deck_parse("LINE\0X", 6, &error);
    ok(deck && loft_deck_error_count(deck) >= 1, "so is one with a null byte");
    loft_deck_free(&deck);
    deck = loft_deck_parse("SECTION A       B       C       D\nSTATION 1.\nEND\n", 49, &error);
    ok(deck && loft_deck_kind(deck) == LOFT_DECK_BODY && loft_deck_error_count(deck) >= 1,
        "a body without lines is in error");
    ok(!loft_cut_station(deck, 1, 0., NULL, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no section", &error), "and has nothing to cut");
    loft_deck_free(&deck);
}

static void bad_cuts(const char *root)
{
    loft_error *error = NULL;
    loft_deck *deck;
    loft_cut *cut;
    loft_point points[30];
    loft_spread spread = {0, 0, 0, 0, 0};
    loft_measure measure;
    loft_section section;
    char path[600];
    double point[3] = {10, 0, -12}, normal[3] = {0, 0, 0};

    snprintf(path, sizeof path, "%s/cards/nose.crd", root);
    deck = loft_deck_load(path, &error);
    ok(deck && loft_deck_body_count(deck) == 1 && loft_deck_section_count(deck, 1) == 1, "the nose is loaded");
    ok(!loft_cut_plane(deck, 1, point, normal, NULL, &error)
        && failed_for(LOFT_POINTS_COINCIDE, "normal of the plane is zero", &error), "a normal of zero is an error");
    ok(!loft_cut_plane(deck, 1, NULL, normal, NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_cut_plane(deck, 1, point, NULL, NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error),
        "so is none at all");
    normal[2] = NAN;
    ok(!loft_cut_plane(deck, 1, point, normal, NULL, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no number", &error), "or NaN");
    ok(!loft_cut_station(deck, 1, INFINITY, NULL, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "infinite", &error), "or a station at infinity");
    ok(!loft_cut_station(deck, 1, 500., NULL, &error)
        && failed_for(LOFT_BEYOND_LINES, "beyond line", &error), "a station beyond the lines is an error");
    ok(!loft_cut_station(deck, 2, 0., NULL, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no body 2", &error), "there is no body 2");
    ok(!loft_cut_station(deck, 0, 0., NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, NULL, &error)
        && !loft_cut_station(deck, -7, 0., NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, NULL, &error),
        "nor one before the first");
    spread.rule = 9;
    ok(!loft_cut_station(deck, 1, 0., &spread, &error) && failed_for(LOFT_BAD_ARGUMENT, "spread", &error),
        "an unknown rule is an error");
    spread.rule = LOFT_NUMBER; spread.number = 1;
    ok(!loft_cut_station(deck, 1, 0., &spread, &error) && failed_for(LOFT_BAD_ARGUMENT, "2 points", &error),
        "and one point on an arc");
    spread.number = 2000000000;
    ok(!loft_cut_station(deck, 1, 0., &spread, &error) && failed_for(LOFT_TOO_MANY, NULL, &error),
        "and two thousand million");
    spread.rule = LOFT_CHORD; spread.step = -1.;
    ok(!loft_cut_station(deck, 1, 0., &spread, &error) && failed_for(LOFT_BAD_ARGUMENT, "above zero", &error),
        "and a step below zero");
    cut = loft_cut_station(deck, 1, 20., NULL, &error);
    ok(cut && !error && loft_cut_kind(cut) == LOFT_STATION && loft_cut_point_count(cut) == 25
        && loft_cut_outline_count(cut) == 1 && !loft_cut_outline_is_closed(cut, 1), "a station has 25 points");
    ok(loft_cut_points(cut, 24, 30, points) == 2 && loft_cut_points(cut, 26, 1, points) == 0
        && loft_cut_points(cut, 0, 5, points) == 0 && loft_cut_points(cut, 1, -5, points) == 0
        && loft_cut_points(cut, 1, 5, NULL) == 0, "no more points are copied than there are");
    ok(loft_cut_points(cut, 1, 25, points) == 25 && points[0].sta == 20. && points[24].slope == INFINITY
        && (points[24].has & LOFT_HAS_SLOPE), "the last has a vertical slope");
    loft_deck_free(&deck);
    ok(loft_cut_points(cut, 1, 1, points) == 1, "a cut outlives its deck");
    loft_cut_free(&cut);
    loft_cut_free(&cut);
    ok(cut == NULL, "and is freed once, however often");

    snprintf(path, sizeof path, "%s/cards/sphere.crd", root);
    deck = loft_deck_load(path, &error);
    ok(loft_deck_measure(deck, 1, &measure, &error) && measure.has_volume && measure.has_wetted
        && measure.volume > 0 && measure.why[0] == '\0', "a sphere has a volume");
    ok(fabs(measure.wetted_area * measure.wetted_area * measure.wetted_area
        / (36 * 3.14159265358979 * measure.volume * measure.volume) - 1.) < 1e-9,
        "and the wetted area that goes with it");
    ok(loft_deck_measure_station(deck, 1, (measure.from + measure.to) / 2, &section, &error)
        && section.has_area && fabs(section.girth * section.girth / (4 * 3.14159265358979 * section.area) - 1.)
        < 1e-9, "its middle is a circle");
    ok(!loft_deck_measure(deck, 1, NULL, &error) && failed_for(LOFT_BAD_ARGUMENT, "NULL", &error)
        && !loft_deck_measure_station(deck, 1, NAN, &section, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no number", &error)
        && !loft_deck_measure(deck, 5, &measure, &error) && failed_for(LOFT_BAD_ARGUMENT, "no body 5", &error),
        "what can't be measured is an error");
    loft_deck_free(&deck);
}

static void bad_ducts(const char *root)
{
    loft_error *error = NULL;
    loft_deck *deck;
    loft_duct duct;
    loft_duct_section section;
    char path[600], name[20];

    snprintf(path, sizeof path, "%s/cards/duct.crd", root);
    deck = loft_deck_load(path, &error);
    ok(deck && loft_deck_duct_count(deck, 1) == 1 && loft_deck_duct_name(deck, 1, 1, name, sizeof name) == 6
        && !strcmp(name, "INTAKE"), "a duct has a name");
    ok(loft_deck_duct_count(deck, 2) == 0 && loft_deck_duct_count(deck, 0) == 0
        && loft_deck_duct_name(deck, 1, 2, name, sizeof name) == 0, "a body that is not there has no duct");
    ok(loft_deck_measure_duct(deck, 1, 1, &duct, &error) && duct.from == 0. && duct.to == 6.5
        && fabs(duct.volume - 7.7) < .3, "a duct has a length and a volume");
    ok(loft_deck_measure_duct_station(deck, 1, 1, 0., &section, &error) && section.sta == 0.
        && fabs(section.area - 1.18) < 1e-9 && section.has_perimeter
        && section.perimeter > 2 * sqrt(3.14159265358979 * section.area), "its lip has the area of its card");
    ok(!loft_deck_measure_duct(deck, 1, 2, &duct, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no duct 2; it has 1", &error)
        && !loft_deck_measure_duct(deck, 2, 1, &duct, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no body 2", &error)
        && !loft_deck_measure_duct(deck, 1, 1, NULL, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "measure is NULL", &error), "what is not there is not measured");
    ok(!loft_deck_measure_duct_station(deck, 1, 1, 6.6, &section, &error)
        && failed_for(LOFT_BEYOND_LINES, "station 0. to 6.5, not to 6.6", &error)
        && !loft_deck_measure_duct_station(deck, 1, 1, NAN, &section, &error)
        && failed_for(LOFT_BAD_ARGUMENT, "no number", &error), "nor is a station beyond its ends, or none");
    ok(duct.to == 6.5 && section.sta == 0., "and what it was to be measured into is as it was");
    loft_deck_free(&deck);
}

int main(int argc, char **argv)
{
    char version[40];
    if (argc != 3) return 2;
    ok(loft_abi_version() == LOFT_ABI_VERSION, "header and library have the same interface");
    ok(loft_version(version, sizeof version) > 0 && !strcmp(version, argv[2]), "and the version of the program");
    null_handles();
    files(".");
    little_room();
    bad_decks(argv[1]);
    bad_cuts(argv[1]);
    bad_ducts(argv[1]);
    printf("1..%d\n", checks);
    return failures > 0;
}
