#include "tests/oracle/rays/rays.h"

#include <cmath> // abs

#include "tests/oracle/lib/verdict.h" // BadInput

static void set_triangles(RTCGeometry geometry,
                          const std::vector<Triangle> &triangles)
{
    size_t count = triangles.size();
    auto *points = static_cast<float *>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
        3 * sizeof(float), 3 * count));
    auto *indices = static_cast<unsigned *>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
    for (size_t i = 0; i < 3 * count; i++)
        indices[i] = unsigned(i);
    for (const Triangle &triangle : triangles)
        for (const glm::dvec3 *p : {&triangle.a, &triangle.b, &triangle.c})
            for (int k = 0; k < 3; k++)
                *points++ = float((*p)[k]);
}

RayScene::RayScene(const Scene &scene, const glm::dvec3 &origin)
    : triangles_(scene_triangles(scene, origin)),
      device_(rtcNewDevice("threads=1")), scene_(nullptr)
{
    if (!device_)
        throw BadInput("Embree: no device");
    scene_ = rtcNewScene(device_);
    // Robust: no ray slips through between two triangles.
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    if (!triangles_.empty()) {
        RTCGeometry geometry =
            rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        set_triangles(geometry, triangles_);
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene_);
}

RayScene::~RayScene()
{
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

static RTCRay embree_ray(const Ray &ray, double start)
{
    RTCRay out = {};
    out.org_x = float(ray.origin.x);
    out.org_y = float(ray.origin.y);
    out.org_z = float(ray.origin.z);
    out.dir_x = float(ray.direction.x);
    out.dir_y = float(ray.direction.y);
    out.dir_z = float(ray.direction.z);
    out.tnear = float(start);
    out.tfar = INFINITY;
    out.mask = ~0u;
    return out;
}

Hit RayScene::first(const Ray &ray, double start) const
{
    RTCRayHit query = {};
    query.ray = embree_ray(ray, start);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree_intersect(scene_, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return {};
    int index = int(query.hit.primID);
    double exact = plane_distance(ray, triangles_[size_t(index)]);
    // Almost edge on, the plane says nothing; Embree's float has to do.
    bool useful = std::abs(exact - query.ray.tfar) <=
                  0.01 * std::abs(double(query.ray.tfar));
    return {index, useful ? exact : double(query.ray.tfar)};
}

bool RayScene::occluded(const Ray &ray, double end) const
{
    RTCRay query = embree_ray(ray, 0);
    query.tfar = float(end);
    embree_occluded(scene_, &query);
    return query.tfar < 0; // Embree's way to say yes
}

namespace
{

struct PlaneQuery {
    const std::vector<Triangle> &triangles;
    glm::dvec3 point, normal;
    bool crossed;
};

} // namespace

// Embree calls this for each triangle near the point; true: the query changed.
static bool visit(RTCPointQueryFunctionArguments *arguments)
{
    auto &query = *static_cast<PlaneQuery *>(arguments->userPtr);
    const Triangle &t = query.triangles[arguments->primID];
    double a = glm::dot(t.a - query.point, query.normal);
    double b = glm::dot(t.b - query.point, query.normal);
    double c = glm::dot(t.c - query.point, query.normal);
    bool above = a > 0 && b > 0 && c > 0, below = a < 0 && b < 0 && c < 0;
    if (above || below || query.crossed)
        return false;
    query.crossed = true;
    arguments->query->radius = 0; // enough is known
    return true;
}

bool RayScene::crosses_plane(const glm::dvec3 &point, const glm::dvec3 &normal,
                             double radius) const
{
    PlaneQuery own{triangles_, point, normal, false};
    RTCPointQuery query = {};
    query.x = float(point.x);
    query.y = float(point.y);
    query.z = float(point.z);
    query.radius = float(radius);
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &query, &context, visit, &own);
    return own.crossed;
}

double plane_distance(const Ray &ray, const Triangle &triangle)
{
    glm::dvec3 normal = triangle.normal();
    double along = glm::dot(normal, ray.direction);
    if (along == 0)
        return INFINITY;
    return glm::dot(normal, triangle.a - ray.origin) / along;
}
