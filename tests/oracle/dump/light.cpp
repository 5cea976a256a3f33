#include "tests/oracle/dump/light.h"

#include "tests/oracle/dump/projection.h"
#include "tests/oracle/lib/rounding.h"

static glm::dvec3 direction(const glm::dvec4 &row)
{
    return glm::dvec3(row);
}

Interval rounded_dot(const glm::dvec3 &a, const glm::dvec3 &b)
{
    double size = 0;
    for (int i = 0; i < 3; i++)
        size += std::abs(a[i] * b[i]);
    // One rounding of each b, three products, two sums: 4 on any one term.
    return widened(glm::dot(a, b), rounding_share(4) * size);
}

glm::dvec3 towards_light(const MapView &view, const glm::dvec3 &point)
{
    if (view.parallel())
        return -glm::normalize(direction(view.rows[2]));
    return view.position - point;
}

double depth_size(const MapView &view, double extent, double t)
{
    if (!view.parallel()) {
        double length = std::sqrt(3.0) * extent + glm::length(view.position);
        double range = view.far - view.near;
        if (view.projected) // sums of both rows over w
            return 1 + (1 + view.far / range) * (length + view.near) /
                           distance_along_axis(view, t);
        return 1 + (length + view.near) / range;
    }
    double size = 1 + std::abs(view.rows[2].w);
    for (int i = 0; i < 3; i++)
        size += std::abs(view.rows[2][i]) * extent;
    return size;
}

double cosine_to_light(const glm::dvec3 &normal, const MapView &view,
                       const glm::dvec3 &point)
{
    return glm::dot(normal, glm::normalize(towards_light(view, point)));
}

// A cosine with the direction to a spot or point light. The direction: its
// position rounded and a difference, against its length, then normalised by 5;
// the rounded other vector, three products and two sums: 5 more.
static Interval local_cosine(const glm::dvec3 &vector, const MapView &view,
                             const glm::dvec3 &point)
{
    glm::dvec3 towards = view.position - point;
    double length = glm::length(towards);
    double size = (glm::length(view.position) + glm::length(point)) / length;
    return widened(glm::dot(vector, towards) / length,
                   rounding_share(2) * size + rounding_share(10));
}

static Facing side(Interval towards)
{
    if (towards.lo > 0)
        return Facing::TOWARDS;
    return towards.hi < 0 ? Facing::AWAY : Facing::UNKNOWN;
}

// 1 - cosine of the angle to the cone's axis, by the length of the difference
// of both directions. Each is off by what local_cosine() says; three squares,
// two sums, a half.
static Facing cone_side(const Receiver &receiver, const MapView &view)
{
    if (view.lamp != Lamp::SPOT)
        return Facing::TOWARDS;
    glm::dvec3 towards = view.position - receiver.position;
    double length = glm::length(towards);
    double size = glm::length(view.position) + glm::length(receiver.position);
    double error = rounding_share(2) * size / length + rounding_share(10);
    double apart = glm::length(direction(view.rows[3]) + towards / length);
    double spread = apart * apart / 2;
    double half = std::sin(view.cone / 2);
    Interval inside = rounded(2 * half * half, UNIT_ROUNDOFF) -
                      widened(spread, apart * error + error * error / 2 +
                                          rounding_share(5) * spread);
    return side(inside);
}

Facing facing(const Receiver &receiver, const MapView &view)
{
    if (view.parallel()) {
        glm::dvec3 t = direction(view.rows[2]);
        Interval away = rounded_dot(receiver.normal, t / glm::length(t));
        return side(Interval(0) - away);
    }
    Facing surface =
        side(local_cosine(receiver.normal, view, receiver.position));
    Facing cone = cone_side(receiver, view);
    if (surface == Facing::AWAY || cone == Facing::AWAY)
        return Facing::AWAY;
    return surface == Facing::TOWARDS ? cone : surface;
}

bool inside_map(const Receiver &r)
{
    return r.u >= 0 && r.u <= 1 && r.v >= 0 && r.v <= 1 && r.t >= 0 && r.t <= 1;
}

// dt/du of the receiver's plane. A plane N.p = c in map space has the gradient
// (N.U/|U|^2, N.V/|V|^2, N.T/|T|^2), so dt/du = -first/third. It faces the
// light, so the third is negative; it is kept at 0.02/|T|, that is N.L at 0.02,
// so the slope stays finite.
static Interval slope(const glm::dvec3 &normal, const glm::dvec3 &axis,
                      const glm::dvec3 &t)
{
    Interval along = rounded_dot(normal, axis) / glm::dot(axis, axis);
    Interval depth = rounded_dot(normal, t) / glm::dot(t, t);
    double least = 0.02 / glm::length(t);
    return along / maximum(magnitude(depth), least);
}

namespace
{

// A vector, and how far (in length) 32-bit arithmetic may be off it.
struct Rounded {
    glm::dvec3 value;
    double error;

    double size() const
    {
        return glm::length(value) + error;
    }
};

} // namespace

// Two products and a difference in each of three components.
static Rounded cross(const Rounded &a, const Rounded &b)
{
    double error = a.error * b.size() + b.error * a.size() +
                   rounding_share(4) * a.size() * b.size();
    return {glm::cross(a.value, b.value), error};
}

static Interval dot(const Rounded &a, const Rounded &b)
{
    double error = a.error * b.size() + b.error * a.size() +
                   rounding_share(3) * a.size() * b.size();
    return widened(glm::dot(a.value, b.value), error);
}

// The gradient of u = U.p / W.p: (U - u W) / (W.p). Both rows are rounded, and
// so are the product and the difference; the quotient's own rounding, and that
// of W.p, is a share of all.
static Rounded gradient(const glm::dvec4 &row, double u, const MapView &view,
                        const glm::dvec3 &p)
{
    glm::dvec3 along = direction(view.rows[3]);
    double w = glm::dot(view.rows[3], glm::dvec4(p, 1));
    double w_size = std::abs(view.rows[3].w);
    for (int i = 0; i < 3; i++)
        w_size += std::abs(along[i] * p[i]);
    glm::dvec3 value = (direction(row) - u * along) / w;
    double terms = (glm::length(direction(row)) + std::abs(u)) / w;
    double share = rounding_share(6) * w_size / w + rounding_share(2);
    return {value, rounding_share(4) * terms + share * glm::length(value)};
}

// dt/du and dt/dv of the receiver's plane under a perspective. On the plane
// u and v are coordinates, so dt = (dt/du) du + (dt/dv) dv for every step in
// it; the step along grad v x N has dv = 0, so dt/du is the ratio of what t and
// u gain on it. N.(grad u x grad v) is held at a fiftieth of its largest value.
static PlaneSlopes local_slopes(const Receiver &r, const MapView &view)
{
    glm::dvec3 away = r.position - view.position;
    double length = glm::length(away), range = view.far - view.near;
    double sizes = glm::length(r.position) + glm::length(view.position);
    Rounded t = {away / length / range,
                 (rounding_share(2) * sizes / length + rounding_share(8)) /
                     range};
    if (view.projected)
        t = gradient(view.rows[2], r.t, view, r.position);
    Rounded u = gradient(view.rows[0], r.u, view, r.position);
    Rounded v = gradient(view.rows[1], r.v, view, r.position);
    Rounded n = {r.normal, 0}, ray = cross(u, v);
    double least = 0.02 * glm::length(ray.value);
    Interval hold =
        widened(least, 0.02 * ray.error + rounding_share(6) * least);
    Interval facing = maximum(magnitude(dot(n, ray)), 0);
    facing = {std::max(facing.lo, hold.lo), std::max(facing.hi, hold.hi)};
    return {dot(t, cross(v, n)) / facing,
            (Interval(0) - dot(t, cross(u, n))) / facing};
}

PlaneSlopes plane_slopes(const Receiver &r, const MapView &view)
{
    if (!view.parallel())
        return local_slopes(r, view);
    glm::dvec3 t = direction(view.rows[2]);
    return {slope(r.normal, direction(view.rows[0]), t),
            slope(r.normal, direction(view.rows[1]), t)};
}

Interval total_bias(const Receiver &receiver, const MapView &view, int width,
                    int height, int n, const Settings &settings)
{
    PlaneSlopes slopes = plane_slopes(receiver, view);
    Interval dx = magnitude(slopes.u) / double(width);
    Interval dy = magnitude(slopes.v) / double(height);
    double texels = settings.slope_bias * (n + 1) / 2;
    Interval bias = settings.bias + texels * (dx + dy);
    // Rounded squares (4 each), quotients, the least depth, sums and products:
    // under 24 operations, all on numbers of one sign.
    return rounded(bias, rounding_share(24));
}
