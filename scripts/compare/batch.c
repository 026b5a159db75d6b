/* The C side of scripts/compare: the protocol of examples/compare.rs, the same loops. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct { double m, r, j, mu, e, vx, vy, w; } sphere;

static uint64_t state = 0x9e3779b97f4a7c15u;

static double unit(void) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    uint64_t bits = 0x3ff0000000000000u | state >> 12;
    double x;
    memcpy(&x, &bits, 8);
    return x - 1.0;
}

__attribute__((noinline)) static void batch(size_t n, const double *restrict a, double *restrict k,
                                            double *restrict i, double *restrict de) {
    for (size_t t = 0; t < n; t++) {
        double s = 1.0 + a[t], x = 1.0 / s;
        k[t] = (1.0 - a[t]) / s;
        i[t] = x;
        de[t] = -(x * x);
    }
}

__attribute__((noinline)) static size_t plain(size_t n, const sphere *restrict p) {
    size_t count = 0;
    for (size_t t = 0; t < n; t++) {
        double s = p[t].mu * ((1.0 + p[t].e) * p[t].vy);
        double slowing = (p[t].j + p[t].m * p[t].r * p[t].r) * s;
        count += p[t].j * fabs(p[t].vx - p[t].w * p[t].r) > slowing;
    }
    return count;
}

int main(void) {
    char work[64];
    size_t n;
    static struct { size_t n; double *a, *k, *i, *de; sphere *p; } known[16];
    volatile size_t sink = 0;
    while (scanf("%63s %zu", work, &n) == 2) {
        int at = 0, columns = strcmp(work, "batch") == 0;
        while (at < 15 && known[at].n && (known[at].n != n || !known[at].a == columns)) at++;
        if (!known[at].n) {
            known[at].n = n;
            if (columns) {
                known[at].a = malloc(8 * n), known[at].k = malloc(8 * n);
                known[at].i = malloc(8 * n), known[at].de = malloc(8 * n);
                for (size_t t = 0; t < n; t++) known[at].a[t] = 3.0 * unit();
                memset(known[at].k, 1, 8 * n), memset(known[at].i, 1, 8 * n), memset(known[at].de, 1, 8 * n);
            } else {
                known[at].p = malloc(sizeof(sphere) * n);
                for (size_t t = 0; t < n; t++)
                    known[at].p[t] = (sphere){0.1 + 2 * unit(), 0.1 + 2 * unit(), 0.1 + 2 * unit(), unit(), unit(),
                                              4 * unit() - 2, 0.1 + 2 * unit(), 4 * unit() - 2};
            }
        }
        struct timespec start, end;
        clock_gettime(CLOCK_MONOTONIC, &start);
        if (columns) batch(n, known[at].a, known[at].k, known[at].i, known[at].de);
        else sink += plain(n, known[at].p);
        clock_gettime(CLOCK_MONOTONIC, &end);
        printf("%lld\n", (end.tv_sec - start.tv_sec) * 1000000000LL + (end.tv_nsec - start.tv_nsec));
        fflush(stdout);
    }
    return (int)(sink & 0);
}
