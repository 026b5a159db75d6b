#include <float.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* An exact number: digits in base 2^32, the least first, times 2^exponent. Nothing of it is rounded. */
typedef struct kane_number {
    struct kane_number *next; /* all of a computation, to be freed */
    int sign;
    long exponent;
    size_t count;
    uint32_t digits[];
} kane_number;

static kane_number *kane_new(kane_number **pool, int sign, long exponent, size_t count) {
    kane_number *made = calloc(1, sizeof *made + count * sizeof made->digits[0]);
    if (made == NULL) abort();
    made->next = *pool;
    made->sign = sign;
    made->exponent = exponent;
    made->count = count;
    return *pool = made;
}

static const kane_number *kane_trim(kane_number *x) {
    while (x->count > 0 && x->digits[x->count - 1] == 0) x->count--;
    if (x->count == 0) x->sign = 0;
    return x;
}

static void kane_free(kane_number *pool) {
    while (pool != NULL) {
        kane_number *next = pool->next;
        free(pool);
        pool = next;
    }
}

/* The value of a finite float. */
static const kane_number *kane_of(kane_number **pool, double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    const long field = (long)(bits >> 52 & 0x7ff);
    uint64_t whole = bits & (((uint64_t)1 << 52) - 1);
    if (field != 0) whole |= (uint64_t)1 << 52;
    kane_number *made = kane_new(pool, bits >> 63 ? -1 : 1, (field ? field : 1) - 1075, 2);
    made->digits[0] = (uint32_t)whole;
    made->digits[1] = (uint32_t)(whole >> 32);
    return kane_trim(made);
}

static const kane_number *kane_integer(kane_number **pool, int sign, size_t count, const uint32_t *digits) {
    kane_number *made = kane_new(pool, sign, 0, count);
    for (size_t i = 0; i < count; i++) made->digits[i] = digits[i];
    return kane_trim(made);
}

/* The digits of x over 2^exponent, for an exponent that is not above its own, in so many places. */
static kane_number *kane_over(kane_number **pool, const kane_number *x, long exponent, size_t count) {
    const size_t by = (size_t)(x->exponent - exponent);
    kane_number *made = kane_new(pool, x->sign, exponent, count);
    uint64_t carry = 0;
    for (size_t i = 0; i < x->count; i++) {
        carry |= (uint64_t)x->digits[i] << (by % 32);
        made->digits[by / 32 + i] = (uint32_t)carry;
        carry >>= 32;
    }
    if (carry != 0) made->digits[by / 32 + x->count] = (uint32_t)carry;
    return made;
}

static const kane_number *kane_signed_sum(kane_number **pool, const kane_number *a, const kane_number *b, int sign_of_b) {
    if (sign_of_b == 0) return a;
    if (a->sign == 0) {
        kane_number *made = kane_new(pool, sign_of_b, b->exponent, b->count);
        memcpy(made->digits, b->digits, b->count * sizeof b->digits[0]);
        return made;
    }
    const long exponent = a->exponent < b->exponent ? a->exponent : b->exponent;
    const size_t of_a = a->count + (size_t)(a->exponent - exponent) / 32;
    const size_t of_b = b->count + (size_t)(b->exponent - exponent) / 32;
    const size_t count = (of_a > of_b ? of_a : of_b) + 2;
    kane_number *large = kane_over(pool, a, exponent, count);
    kane_number *small = kane_over(pool, b, exponent, count);
    const int same = a->sign == sign_of_b;
    small->sign = sign_of_b;
    if (!same) {
        size_t i = count;
        while (i > 0 && large->digits[i - 1] == small->digits[i - 1]) i--;
        if (i > 0 && large->digits[i - 1] < small->digits[i - 1]) {
            kane_number *other = large;
            large = small;
            small = other;
        }
    }
    uint64_t carry = 0; /* what is carried, or borrowed */
    for (size_t i = 0; i < count; i++) {
        if (same) {
            carry += (uint64_t)large->digits[i] + small->digits[i];
            large->digits[i] = (uint32_t)carry;
            carry >>= 32;
        } else {
            const uint64_t taken = (uint64_t)small->digits[i] + carry;
            carry = large->digits[i] < taken;
            large->digits[i] = (uint32_t)(large->digits[i] - taken);
        }
    }
    return kane_trim(large);
}

static const kane_number *kane_sum(kane_number **pool, const kane_number *a, const kane_number *b) {
    return kane_signed_sum(pool, a, b, b->sign);
}

static const kane_number *kane_difference(kane_number **pool, const kane_number *a, const kane_number *b) {
    return kane_signed_sum(pool, a, b, -b->sign);
}

static const kane_number *kane_product(kane_number **pool, const kane_number *a, const kane_number *b) {
    kane_number *made = kane_new(pool, a->sign * b->sign, a->exponent + b->exponent, a->count + b->count);
    for (size_t i = 0; i < a->count; i++) {
        uint64_t carry = 0;
        for (size_t j = 0; j < b->count; j++) {
            carry += (uint64_t)a->digits[i] * b->digits[j] + made->digits[i + j];
            made->digits[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
        made->digits[i + b->count] = (uint32_t)carry;
    }
    return kane_trim(made);
}

/* The sign of a + b*sqrt(c), of those of a, b and a^2 - b^2*c. */
static int kane_root_sign(int a, int b, int norm) {
    return b == 0 || a == b ? a : norm > 0 ? a : norm < 0 ? b : 0;
}

/* Half an ulp of 1; more than a few roundings of a bound lose; more than a few underflows. */
static const double KANE_HALF = 1.1102230246251565e-16, KANE_MORE = 1.0000000000000036, KANE_TINY = 1e-310;
