#include "step1_shadowmap/base/picture/geometry.h"

#include <cglm/mat3.h> // glm_mat3_inv, glm_mat3_transpose
#include <cglm/mat4.h> // glm_mat4_pick3
#include <stddef.h>    // offsetof
#include <stdlib.h>    // free
#include <string.h>    // memcpy

// The attributes, as the vertex shaders number them.
enum { POSITION, NORMAL, FIRST_OF_OBJECT, NORMAL_MATRIX = 6, ATTRIBUTES = 10 };

// What the vertex shader is given of an object: columns of matrices, and last
// its colour.
typedef struct Instance {
    float relative_from_object[4][3];
    float normal_from_object[3][3];
    float albedo[3];
} Instance;

static void upload(GLenum target, GLuint buffer, const void *data, size_t bytes)
{
    glBindBuffer(target, buffer);
    glBufferData(target, (GLsizeiptr)bytes, data, GL_STATIC_DRAW);
}

static void point_at(GLuint attribute, size_t stride, size_t offset)
{
    glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, (GLsizei)stride,
                          (void *)offset);
}

static void upload_surface(const Mesh *mesh, GLuint vertices, GLuint indices)
{
    upload(GL_ARRAY_BUFFER, vertices, mesh->vertices,
           mesh->vertex_count * sizeof(MeshVertex));
    upload(GL_ELEMENT_ARRAY_BUFFER, indices, mesh->indices,
           mesh->index_count * sizeof(uint32_t));
    point_at(POSITION, sizeof(MeshVertex), offsetof(MeshVertex, position));
    point_at(NORMAL, sizeof(MeshVertex), offsetof(MeshVertex, normal));
}

static void upload_shape(const Mesh *mesh, GLuint vertices, GLuint indices)
{
    Shape shape;
    if (shape_of_mesh == NULL || !shape_of_mesh(mesh, &shape)) {
        upload_surface(mesh, vertices, indices);
        return;
    }
    upload(GL_ARRAY_BUFFER, vertices, shape.positions,
           shape.count * sizeof shape.positions[0]);
    upload(GL_ELEMENT_ARRAY_BUFFER, indices, shape.indices,
           mesh->index_count * sizeof(uint32_t));
    point_at(POSITION, sizeof shape.positions[0], 0);
    free(shape.positions);
    free(shape.indices);
}

static GeometryStream create_stream(const Scene *scene,
                                    void upload_mesh(const Mesh *, GLuint,
                                                     GLuint))
{
    GeometryStream stream = {.vao = {0}};
    glGenVertexArrays(scene->mesh_count, stream.vao);
    glGenBuffers(scene->mesh_count, stream.vertices);
    glGenBuffers(scene->mesh_count, stream.indices);
    for (int i = 0; i < scene->mesh_count; i++) {
        glBindVertexArray(stream.vao[i]);
        upload_mesh(&scene->meshes[i], stream.vertices[i], stream.indices[i]);
    }
    return stream;
}

Geometry geometry_create(const Scene *scene)
{
    Geometry geometry = {.surfaces = create_stream(scene, upload_surface),
                         .shapes = create_stream(scene, upload_shape)};
    glGenBuffers(1, &geometry.instances);
    return geometry;
}

static void destroy_stream(GeometryStream *stream)
{
    // Names that are 0 (meshes the scene does not have) are ignored.
    glDeleteBuffers(SCENE_MAX_MESHES, stream->indices);
    glDeleteBuffers(SCENE_MAX_MESHES, stream->vertices);
    glDeleteVertexArrays(SCENE_MAX_MESHES, stream->vao);
}

void geometry_destroy(Geometry *geometry)
{
    glDeleteBuffers(1, &geometry->instances);
    destroy_stream(&geometry->shapes);
    destroy_stream(&geometry->surfaces);
    *geometry = (Geometry){.instances = 0};
}

// world_from_object with the origin taken away in double, then rounded.
static void relative_matrix(const Object *object, const double origin[3],
                            float columns[4][3])
{
    for (int row = 0; row < 3; row++) {
        const double *m = object->transform[row];
        for (int column = 0; column < 3; column++) {
            columns[column][row] = (float)m[column];
        }
        columns[3][row] = (float)(m[3] - origin[row]);
    }
}

static void fill_instance(Instance *instance, const Object *object,
                          const double origin[3])
{
    relative_matrix(object, origin, instance->relative_from_object);
    // Normals go with the inverse transpose, else a stretched object's would
    // lean the wrong way.
    mat3 normal_from_object;
    memcpy(normal_from_object, instance->relative_from_object,
           sizeof normal_from_object);
    glm_mat3_inv(normal_from_object, normal_from_object);
    glm_mat3_transpose(normal_from_object);
    memcpy(instance->normal_from_object, normal_from_object,
           sizeof normal_from_object);
    memcpy(instance->albedo, object->albedo, sizeof instance->albedo);
}

// Puts what differs between the objects into the buffer, in the list's order.
static void upload_instances(const Geometry *geometry, const Scene *scene,
                             const DrawList *list, const double origin[3])
{
    Instance instances[SCENE_MAX_OBJECTS];
    for (int i = 0; i < list->count; i++) {
        fill_instance(&instances[i], &scene->objects[list->objects[i]], origin);
    }
    glBindBuffer(GL_ARRAY_BUFFER, geometry->instances);
    glBufferData(GL_ARRAY_BUFFER,
                 (GLsizeiptr)((size_t)list->count * sizeof *instances),
                 instances, GL_STREAM_DRAW);
}

// OpenGL 3.3 cannot begin with any other than the first instance, so the
// attributes are moved instead.
static void point_at_instances(int first, GLuint attributes)
{
    size_t offset = (size_t)first * sizeof(Instance);
    for (GLuint i = FIRST_OF_OBJECT; i < attributes; i++) {
        point_at(i, sizeof(Instance), offset);
        glVertexAttribDivisor(i, 1);
        offset += 3 * sizeof(float);
    }
}

// Objects of one mesh are drawn together only where they follow each other on
// the list: where two surfaces are equally far, the order shows.
static void draw(const GeometryStream *stream, GLuint attributes,
                 const Scene *scene, const DrawList *list)
{
    int end = 0;
    for (int first = 0; first < list->count; first = end) {
        const Mesh *mesh = scene->objects[list->objects[first]].mesh;
        end = first + 1;
        while (end < list->count &&
               scene->objects[list->objects[end]].mesh == mesh) {
            end++;
        }
        glBindVertexArray(stream->vao[mesh - scene->meshes]);
        point_at_instances(first, attributes);
        glDrawElementsInstanced(GL_TRIANGLES, (GLsizei)mesh->index_count,
                                GL_UNSIGNED_INT, NULL, end - first);
    }
}

void geometry_draw(const Geometry *geometry, const Scene *scene,
                   const DrawList *list, const double origin[3])
{
    upload_instances(geometry, scene, list, origin);
    draw(&geometry->surfaces, ATTRIBUTES, scene, list);
}

void geometry_draw_shapes(const Geometry *geometry, const Scene *scene,
                          const DrawList *list, const double origin[3])
{
    upload_instances(geometry, scene, list, origin);
    draw(&geometry->shapes, NORMAL_MATRIX, scene, list);
}
