// Intervals in double: every value that a 32-bit program may have computed.
// The ends are not rounded outwards, because the oracle's own rounding is
// 2^-53 and every interval here has been widened by some 2^-24 before.
#ifndef ORACLE_INTERVAL_H
#define ORACLE_INTERVAL_H

#include <algorithm> // min, max, clamp
#include <cmath>     // abs

struct Interval {
    double lo = 0, hi = 0;

    Interval() = default;
    Interval(double value) : lo(value), hi(value)
    {
    }
    Interval(double low, double high) : lo(low), hi(high)
    {
    }

    double width() const
    {
        return hi - lo;
    }
    bool contains(double x) const
    {
        return lo <= x && x <= hi;
    }

    // How far x lies outside, 0 inside.
    double distance(double x) const
    {
        return std::max({lo - x, x - hi, 0.0});
    }
};

inline Interval operator+(Interval a, Interval b)
{
    return {a.lo + b.lo, a.hi + b.hi};
}

inline Interval operator-(Interval a, Interval b)
{
    return {a.lo - b.hi, a.hi - b.lo};
}

inline Interval operator*(Interval a, Interval b)
{
    double products[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    return {*std::min_element(products, products + 4),
            *std::max_element(products, products + 4)};
}

// b must not contain 0.
inline Interval operator/(Interval a, Interval b)
{
    return a * Interval(1 / b.hi, 1 / b.lo);
}

inline Interval magnitude(Interval a)
{
    if (a.lo >= 0)
        return a;
    return a.hi <= 0 ? Interval(-a.hi, -a.lo)
                     : Interval(0, std::max(-a.lo, a.hi));
}

inline Interval square(Interval a)
{
    Interval m = magnitude(a);
    return {m.lo * m.lo, m.hi * m.hi};
}

inline Interval maximum(Interval a, Interval b)
{
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi)};
}

inline Interval clamp(Interval a, double low, double high)
{
    return {std::clamp(a.lo, low, high), std::clamp(a.hi, low, high)};
}

// The smallest interval that holds both.
inline Interval hull(Interval a, Interval b)
{
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

// Grown by `amount` at both ends.
inline Interval widened(Interval a, double amount)
{
    return {a.lo - amount, a.hi + amount};
}

// Grown by a share of the end's own magnitude: a relative rounding error.
inline Interval rounded(Interval a, double share)
{
    return {a.lo - share * std::abs(a.lo), a.hi + share * std::abs(a.hi)};
}

#endif
