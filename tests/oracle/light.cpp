#include "tests/oracle/light.h"

#include "tests/oracle/rounding.h"

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

double cosine_to_light(const glm::dvec3 &normal, const MapView &view)
{
    glm::dvec3 t = direction(view.rows[2]);
    return -glm::dot(normal, t) / glm::length(t);
}

Facing facing(const Receiver &receiver, const MapView &view)
{
    glm::dvec3 t = direction(view.rows[2]);
    Interval dot = rounded_dot(receiver.normal, t / glm::length(t));
    if (dot.hi < 0)
        return Facing::TOWARDS;
    return dot.lo > 0 ? Facing::AWAY : Facing::UNKNOWN;
}

bool inside_map(const Receiver &r)
{
    return r.u >= 0 && r.u <= 1 && r.v >= 0 && r.v <= 1 && r.t >= 0 && r.t <= 1;
}

// |dt/du| of the receiver's plane. A plane N.p = c in map space has the
// gradient (N.U/|U|^2, N.V/|V|^2, N.T/|T|^2), so dt/du = -first/third. The
// third is kept at 0.1/|T|, that is N.L at 0.1, so the slope stays finite.
static Interval slope(const glm::dvec3 &normal, const glm::dvec3 &axis,
                      const glm::dvec3 &t)
{
    Interval along = rounded_dot(normal, axis) / glm::dot(axis, axis);
    Interval depth = rounded_dot(normal, t) / glm::dot(t, t);
    double least = 0.1 / glm::length(t);
    return magnitude(along) / maximum(magnitude(depth), least);
}

Interval total_bias(const Receiver &receiver, const MapView &view, int width,
                    int height, int n, const Settings &settings)
{
    glm::dvec3 t = direction(view.rows[2]);
    glm::dvec3 u = direction(view.rows[0]), v = direction(view.rows[1]);
    Interval dx = slope(receiver.normal, u, t) / double(width);
    Interval dy = slope(receiver.normal, v, t) / double(height);
    double texels = settings.slope_bias * (n + 1) / 2;
    Interval bias = settings.bias + texels * (dx + dy);
    // Rounded squares (4 each), quotients, the least depth, sums and products:
    // under 24 operations, all on numbers of one sign.
    return rounded(bias, rounding_share(24));
}
