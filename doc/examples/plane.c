/* Cuts the first body of a deck by any plane and prints the points:
 *
 *     plane DECK STA BL WL NX NY NZ
 *
 *     cc plane.c $(pkg-config --cflags --libs loft) -o plane
 */
#include <loft.h>
#include <stdio.h>
#include <stdlib.h>

/* Says why a call failed, and frees the error. */
static int complain(loft_error **error)
{
    char message[512];
    loft_error_message(*error, message, sizeof message);
    fprintf(stderr, "plane: %s\n", message);
    loft_error_free(error);
    return EXIT_FAILURE;
}

/* Says what is wrong with the cards of a deck. */
static void print_faults(const loft_deck *deck, const char *path)
{
    int i;
    for (i = 1; i <= loft_deck_fault_count(deck); i++) {
        loft_fault fault;
        char message[512];
        loft_deck_fault(deck, i, &fault);
        loft_deck_fault_message(deck, i, message, sizeof message);
        fprintf(stderr, "%s:%ld:%d-%d: %s: %s\n", path, (long)fault.line, (int)fault.first,
            (int)fault.last, fault.severity == LOFT_ERROR ? "error" : "warning", message);
    }
}

static void print_points(const loft_cut *cut)
{
    int i;
    printf("section,sta,bl,wl,slope,curvature,bevel\n");
    for (i = 1; i <= loft_cut_point_count(cut); i++) {
        loft_point point;
        char section[16];
        loft_cut_points(cut, i, 1, &point);
        loft_cut_section_name(cut, point.section, section, sizeof section);
        printf("%s,%.17g,%.17g,%.17g,", section, point.sta, point.bl, point.wl);
        if (point.has & LOFT_HAS_SLOPE) printf("%.17g", point.slope);
        printf(",");
        if (point.has & LOFT_HAS_CURVATURE) printf("%.17g", point.curvature);
        printf(",");
        if (point.has & LOFT_HAS_NORMAL) printf("%.17g", point.bevel);
        printf("\n");
    }
}

int main(int argc, char **argv)
{
    double point[3], normal[3];
    loft_error *error = NULL;
    loft_deck *deck;
    loft_cut *cut;
    int i;

    if (argc != 8) {
        fprintf(stderr, "usage: plane DECK STA BL WL NX NY NZ\n");
        return EXIT_FAILURE;
    }
    for (i = 0; i < 3; i++) {
        point[i] = strtod(argv[2 + i], NULL);
        normal[i] = strtod(argv[5 + i], NULL);
    }
    deck = loft_deck_load(argv[1], &error);
    if (!deck) return complain(&error);
    print_faults(deck, argv[1]);
    cut = loft_cut_plane(deck, 1, point, normal, NULL, &error);
    loft_deck_free(&deck);
    if (!cut) return complain(&error);
    print_points(cut);
    loft_cut_free(&cut);
    return EXIT_SUCCESS;
}
