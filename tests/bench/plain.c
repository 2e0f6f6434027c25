/* The obvious program of tests/bench/tables.f90 in C, and the floor under all of them:
 *
 *     plain print DECK     reads the cards, solves, prints the five columns with printf
 *     plain write BYTES    writes so many bytes from one buffer in memory
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const double shift = 100.0;

/* A to E of the conic through three points with two slopes, by elimination with pivoting. */
static void solve(const double card[10], double a[5])
{
    const double x[3] = {card[0] + shift, card[3] + shift, card[5] + shift};
    const double y[3] = {card[1] + shift, card[4] + shift, card[6] + shift};
    double w[5][6];

    for (int i = 0; i < 3; i++) {
        const double row[6] = {x[i] * x[i], x[i] * y[i], y[i] * y[i], x[i], y[i], -1.0};
        memcpy(w[i], row, sizeof row);
    }
    for (int i = 0; i < 2; i++) {
        const double s = card[i ? 7 : 2], u = x[2 * i], v = y[2 * i];
        const double row[6] = {2.0 * u, v + s * u, 2.0 * s * v, 1.0, s, 0.0};
        memcpy(w[3 + i], row, sizeof row);
    }
    for (int k = 0; k < 5; k++) {
        int pivot = k;
        for (int i = k + 1; i < 5; i++)
            if (fabs(w[i][k]) > fabs(w[pivot][k]))
                pivot = i;
        for (int j = 0; j < 6; j++) {
            const double other = w[pivot][j];
            w[pivot][j] = w[k][j];
            w[k][j] = other;
        }
        for (int j = 5; j >= k; j--)
            w[k][j] /= w[k][k];
        for (int i = 0; i < 5; i++) {
            const double factor = w[i][k];
            for (int j = k; i != k && j < 6; j++)
                w[i][j] -= factor * w[k][j];
        }
    }
    for (int i = 0; i < 5; i++)
        a[i] = w[i][5];
}

/* Steps X and prints a row for each step. */
static void print_table(const double card[10], const double k[5])
{
    const double degrees = 180.0 / acos(-1.0);
    const int steps = (int)lround((card[5] - card[0]) / card[8]);
    double y = card[1] + shift;

    for (int i = 0; i <= steps; i++) {
        const double x = card[0] + i * card[8] + shift;
        const double h = k[1] * x + k[4], g = (k[0] * x + k[3]) * x + 1.0;
        const double r = sqrt(fabs(h * h - 4.0 * k[2] * g));
        const double one = (-h + r) / (2.0 * k[2]), other = (-h - r) / (2.0 * k[2]);
        y = fabs(one - y) < fabs(other - y) ? one : other;
        const double fx = 2.0 * k[0] * x + k[1] * y + k[3];
        const double fy = k[1] * x + 2.0 * k[2] * y + k[4];
        const double radius = pow(sqrt(fx * fx + fy * fy), 3.0) /
            (2.0 * k[1] * fx * fy - 2.0 * k[0] * fy * fy - 2.0 * k[2] * fx * fx);
        printf("%14.4f%14.4f%14.6f%12.4f%22.4f\n", x - shift, y - shift, -fx / fy,
               atan(-fx / fy) * degrees, fy < 0.0 ? -radius : radius);
    }
}

/* Prints the tables of a deck. */
static int print_deck(const char *path)
{
    char line[256];
    double card[10], a[5];
    FILE *deck = fopen(path, "r");

    if (!deck)
        return 1;
    while (fgets(line, sizeof line, deck)) {
        char *rest = line;
        for (int i = 0; i < 10; i++)
            card[i] = strtod(rest, &rest);
        solve(card, a);
        print_table(card, a);
    }
    return fclose(deck);
}

/* Writes bytes, a megabyte at a time. */
static int write_bytes(long left)
{
    static char buffer[1 << 20];

    memset(buffer, 'x', sizeof buffer);
    while (left > 0) {
        const size_t size = left < (long)sizeof buffer ? (size_t)left : sizeof buffer;
        const ssize_t taken = write(1, buffer, size);
        if (taken < 0)
            return 1;
        left -= taken;
    }
    return 0;
}

int main(int count, char **word)
{
    if (count == 3 && !strcmp(word[1], "print"))
        return print_deck(word[2]);
    if (count == 3 && !strcmp(word[1], "write"))
        return write_bytes(atol(word[2]));
    return 2;
}
